// The study of the page, from its embedded data.

import { nameFigures } from './figure';

export const page = JSON.parse(document.getElementById('data').textContent);
nameFigures(page.name || '');
