// hide_helpers.js - hides all but the exercises in a compiled answer, because helpers of two chapters may have one name.
// In the terminal objcopy --keep-global-symbols does it, which knows no WebAssembly objects.
//
// The symbols are in the section 'linking' of the object (WebAssembly/tool-conventions, Linking.md).
const WEAK = 1, LOCAL = 2, UNDEFINED = 0x10, EXPLICIT_NAME = 0x40;
const FUNCTION = 0, DATA = 1, SECTION = 3, SYMBOL_TABLE = 8;

/**
 * @param {Uint8Array} object
 * @param {Set<string>} kept the names that stay global
 * @returns {Uint8Array} a copy
 */
export function hideHelpers(object, kept) {
  const bytes = object.slice(), text = new TextDecoder();
  let at = 8;
  const number = () => {
    let value = 0, shift = 0, byte;
    do {
      byte = bytes[at++];
      value += (byte & 0x7f) * 2 ** shift;
      shift += 7;
    } while (byte & 0x80);
    return value;
  };
  const name = () => { const size = number(); return text.decode(bytes.subarray(at, at += size)); };
  function symbol() {
    const kind = bytes[at++], place = at, flags = number(), isDefined = !(flags & UNDEFINED);
    if (kind === SECTION) { number(); return; }
    let named;
    if (kind === DATA) {
      named = name();
      if (isDefined) { number(); number(); number(); }
    } else {
      number();
      if (isDefined || flags & EXPLICIT_NAME) named = name();
    }
    // Both flags are in the first byte of their number.
    if (isDefined && (kind === FUNCTION || kind === DATA) && !kept.has(named)) bytes[place] = bytes[place] & ~WEAK | LOCAL;
  }
  while (at < bytes.length) {
    const id = bytes[at++], size = number(), end = at + size;
    if (id === 0 && name() === 'linking') {
      number(); // the version
      while (at < end) {
        const kind = bytes[at++], length = number(), after = at + length;
        if (kind === SYMBOL_TABLE) for (let count = number(); count > 0; count--) symbol();
        at = after;
      }
    }
    at = end;
  }
  return bytes;
}
