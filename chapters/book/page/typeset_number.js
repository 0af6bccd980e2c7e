// typeset_number.js - a number of a lesson, which is TeX in a formula, as text in a formula.
export const typesetNumber = (tex) => tex.replaceAll("\\approx", "≈").replaceAll("-", "−");
