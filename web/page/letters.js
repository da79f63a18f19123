// Bytes from the letters that the libraries and scripts stand in: each two of 91 letters are thirteen bits, where two of base64
// are twelve.

// Letters from ! on, but for those that mean something in HTML.
const VALUES = new Uint8Array(128);
let next = 0;
for (let code = 33; code < 127; code++) {
  if (!'"&<'.includes(String.fromCharCode(code))) VALUES[code] = next++;
}

export function bytesOf(letters) {
  const pairs = Math.floor(letters.length / 2);
  const isOdd = letters.length % 2 === 1;
  const bytes = new Uint8Array(Math.floor((13 * pairs + (isOdd ? 6 : 0)) / 8));
  let held = 0;
  let count = 0;
  let to = 0;
  const add = (bits, number) => {
    held = (held << bits) | number;
    count += bits;
    while (count >= 8) {
      count -= 8;
      bytes[to++] = held >> count;
      held &= (1 << count) - 1;
    }
  };
  for (let pair = 0; pair < pairs; pair++) {
    add(13, 91 * VALUES[letters.charCodeAt(2 * pair)] + VALUES[letters.charCodeAt(2 * pair + 1)]);
  }
  // A last letter alone is six bits.
  if (isOdd) add(6, VALUES[letters.charCodeAt(2 * pairs)]);
  return bytes;
}

/** What an element of the page holds by gzip, in letters. */
export function unzipped(id) {
  const bytes = bytesOf(document.getElementById(id).textContent);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}
