// kept.js - the list of the functions that a cut compiler keeps, as text: the SHA-256 of the whole one, then a bit for each
// function in hexadecimal digits, 100 a line.
const DIGITS = 100;

/** @param {ArrayLike<number>} entered for each function, not 0 if it is kept */
export function keptText(hash, entered) {
  let text = '';
  for (let i = 0; i < entered.length; i += 4) {
    let digit = 0;
    for (let k = 0; k < 4; k++) digit |= (entered[i + k] ? 1 : 0) << k;
    text += digit.toString(16);
  }
  return `${hash}\n${text.replace(new RegExp(`.{1,${DIGITS}}`, 'g'), '$&\n')}`;
}

/** @returns {{hash: string, isKept: (index: number) => boolean}} */
export function keptList(text) {
  const [hash, ...lines] = text.split('\n'), digits = lines.join('');
  return {hash, isKept: index => (parseInt(digits[index >> 2], 16) >> (index & 3) & 1) === 1};
}
