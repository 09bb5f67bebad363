// Fits tables to the width of a column on paper. The print style is applied once to measure them: a table that is too wide is printed
// in a smaller font, down to a readable size, and beyond that its words and numbers are broken.


export const paper = {width: '184mm', least: 0.7};  // of A4 between the margins of style.css, and of each column of A3

export function onPaper(measure, width = paper.width) {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]).filter((rule) => rule.media && rule.media.mediaText === 'print');
  rules.forEach((rule) => { rule.media.mediaText = 'all'; });
  document.body.style.width = width;
  measure();
  document.body.style.width = '';
  rules.forEach((rule) => { rule.media.mediaText = 'print'; });
}

export function fitTablesToPaper() {
  const columns = document.body.className;
  document.body.className = '';  // a page as wide as a column
  onPaper(() => {
    for (const node of document.querySelectorAll('.scroll > table')) {
      const room = () => node.parentNode.clientWidth / node.offsetWidth;
      const setSize = (size) => node.style.setProperty('--on-paper', size);
      let size = 1;
      while (room() < 1 && size > paper.least) setSize(size = Math.max(paper.least, size - 0.05));
      if (room() < 1) node.classList.add('broken');
    }
  });
  document.body.className = columns;
}
