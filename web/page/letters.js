// Bytes from the letters that the libraries stand in: each five of 85 letters are four bytes, a quarter more than the bytes, where base64
// is a third more.

// Letters from # on, but for those that mean something in HTML or in scripts.
const VALUES = new Uint8Array(128);
let next = 0;
for (let code = 35; code < 127; code++) {
  if (!"&'<>\\\x60~".includes(String.fromCharCode(code))) VALUES[code] = next++;
}

export function bytesOf(letters) {
  const bytes = new Uint8Array(letters.length - Math.ceil(letters.length / 5));
  for (let from = 0, to = 0; from < letters.length; from += 5, to += 4) {
    let number = 0;
    // A last group of fewer letters is filled up by the highest, and of fewer bytes.
    for (let place = from; place < from + 5; place++) {
      number = number * 85 + (place < letters.length ? VALUES[letters.charCodeAt(place)] : 84);
    }
    for (let place = 0; place < 4; place++) {
      if (to + place < bytes.length) bytes[to + place] = number / 2 ** (24 - 8 * place);
    }
  }
  return bytes;
}
