// Bytes from the letters that the libraries and scripts stand in: each two of 124 letters are thirteen or fourteen bits, where two of
// base64 are twelve.

// All letters of one byte, but for those that a page does not keep (NUL, \r), the one that ends an element, and one that ended files.
const VALUES = new Uint8Array(128);
let next = 0;
for (let code = 1; code < 128; code++) {
  if (!"\r<\x1a".includes(String.fromCharCode(code))) VALUES[code] = next++;
}

// Pairs below it are thirteen bits, which are the pair; others are fourteen, which are it more than the pair.
const SHORT = 2 ** 14 - 124 ** 2;

export function bytesOf(letters) {
  const bytes = new Uint8Array(Math.ceil((7 * letters.length) / 8));
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
  for (let at = 0; at + 1 < letters.length; at += 2) {
    const pair = 124 * VALUES[letters.charCodeAt(at)] + VALUES[letters.charCodeAt(at + 1)];
    if (pair < SHORT) add(13, pair);
    else add(14, pair + SHORT);
  }
  // A last letter alone is six bits.
  if (letters.length % 2 === 1) add(6, VALUES[letters.charCodeAt(letters.length - 1)]);
  return bytes.subarray(0, to);
}

/** What an element of the page holds by gzip, in letters. */
export function unzipped(id) {
  const bytes = bytesOf(document.getElementById(id).textContent);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}
