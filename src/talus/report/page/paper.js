// Fits tables to the paper width. The print style is applied once to measure them: a table that is too wide is printed
// in a smaller font, down to a readable size, and beyond that its words and numbers are broken.

const paper = {width: '184mm', least: 0.7};  // A4 between the margins of style.css

function onPaper(measure) {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]).filter((rule) => rule.media && rule.media.mediaText === 'print');
  rules.forEach((rule) => { rule.media.mediaText = 'all'; });
  document.body.style.width = paper.width;
  measure();
  document.body.style.width = '';
  rules.forEach((rule) => { rule.media.mediaText = 'print'; });
}

function fitTablesToPaper() {
  onPaper(() => {
    for (const node of document.querySelectorAll('.scroll > table')) {
      const room = () => node.parentNode.clientWidth / node.offsetWidth;
      const setSize = (size) => node.style.setProperty('--on-paper', size);
      let size = 1;
      while (room() < 1 && size > paper.least) setSize(size = Math.max(paper.least, size - 0.05));
      if (room() < 1) node.classList.add('broken');
    }
  });
}
