// uPlot makes a number format of the browser's language while it loads, which throws where that is none, such as “C”.
try {
  new Intl.NumberFormat(navigator.language);
} catch {
  Object.defineProperty(navigator, 'language', { value: 'en' });
}
