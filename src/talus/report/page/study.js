// The study of the page, from its embedded data.

const page = JSON.parse(document.getElementById('data').textContent);
const single = true;
const runs = [page];  // figures are named after the study
