// A library of materials of one's own: values are saved from one project and copied into another.

import type { Page } from '@playwright/test';
import { openExample, openForm, openProject, projectText, toStartPage } from '../support/steps';
import { expect, test } from '../support/workbench';

const file = 'own.materials.toml';
const saveMaterial = (page: Page) => page.getByRole('button', { name: 'Save to my materials' }).click();

async function openLibrary(page: Page) {
  await page.getByRole('button', { name: '+ From the library…' }).click();
  return page.getByRole('dialog', { name: 'Add materials from the library' });
}

test('a material is saved, replaced, used in another project, and deleted', async ({ workbench: page, server }) => {
  const missing: string[] = [];
  page.on('response', (response) => void (response.status() === 404 && response.url().includes(file) && missing.push(response.url())));
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type Two/);
  await saveMaterial(page);
  await expect(page.getByText(`Saved Type Two in ${file}`)).toBeVisible();
  expect(missing).toEqual([]);
  const today = new Date().toISOString().slice(0, 10);
  const values = `name = "Type Two"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
tangential_restitution = { mean = 0.9, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
friction_angle_deg = 30
`;
  expect(server.read(file)).toBe(
    `# Materials of one's own, for the workbench (talus serve), which copies them into projects.\n[[material]]\n${values}saved_from = "tutorial-1/tutorial-1-2d.toml"\nsaved_on = "${today}"\n`,
  );

  // Another program adds one; it is kept.
  server.write(file, `${server.read(file)}\n# Ours\n[[material]]\nname = "My scree"\nlike = "talus_cover"\nfriction_angle_deg = 38\n`);
  await page.locator('[data-path="material.1.friction_angle_deg"] input').first().fill('31');
  await page.keyboard.press('Tab');
  await saveMaterial(page);
  await page.getByRole('dialog', { name: 'Replace Type Two?' }).getByRole('button', { name: 'Replace' }).click();
  await expect.poll(() => server.read(file)).toContain('friction_angle_deg = 31');
  expect(server.read(file)).toContain('# Ours\n[[material]]\nname = "My scree"\nlike = "talus_cover"\nfriction_angle_deg = 38\n');
  expect(server.read(file).match(/Type Two/g)).toHaveLength(1);

  await toStartPage(page);
  await expect(page.getByRole('region', { name: 'Projects in this folder' })).not.toContainText(file);
  await openExample(page, 'Sliding');
  const dialog = await openLibrary(page);
  const own = dialog.getByRole('table', { name: 'My materials' });
  await expect(own.getByRole('row', { name: /^My scree/ })).toContainText('38');
  await expect(own.getByRole('rowheader', { name: 'Type Two' })).toHaveAttribute('title', `saved from tutorial-1/tutorial-1-2d.toml, ${today}`);
  await own.getByRole('button', { name: 'Add My scree' }).click();
  await expect(own.getByRole('row', { name: /^My scree/ })).toContainText('in the project');
  // The dialog stays, for more than one.
  await own.getByRole('button', { name: 'Add Type Two' }).click();
  await dialog.getByRole('button', { name: 'Close' }).click();
  await expect.poll(() => projectText(page)).toContain(`# From ${file}\n[[material]]\nname = "My scree"\nlike = "talus_cover"\nfriction_angle_deg = 38\n`);
  expect(await projectText(page)).toContain(`# From ${file}, saved there from tutorial-1/tutorial-1-2d.toml on ${today}\n[[material]]\n`);

  const again = await openLibrary(page);
  await again.getByRole('button', { name: 'Delete My scree from my materials' }).click();
  await again.getByRole('button', { name: 'Delete My scree from my materials for good' }).click();
  await expect.poll(() => server.read(file)).not.toContain('My scree');
  expect(await again.getByRole('table').count()).toBe(2);
});

test('a material that takes the values of the library takes its name, too, unless the user has named it', async ({ workbench: page, server }) => {
  server.write('cliff.toml', 'name = "Cliff"\n\n[terrain]\nsection = [[0, 0], [10, -20], [30, -20]]\n\n[[material]]\nname = "Material 1"\n\n[ground]\ndefault = "Material 1"\n');
  await page.reload();
  await openProject(page, 'cliff.toml');
  await openForm(page, /^Material 1/);
  const like = page.locator('[data-path="material.0.like"] select');
  await like.selectOption('bedrock_outcrops');
  const name = page.locator('[data-path="material.0.name"] input');
  await expect(name).toHaveValue('Bedrock outcrops with hard surface, large boulders');
  await like.selectOption('talus_cover');
  await expect(name).toHaveValue('Talus cover');
  await expect.poll(() => projectText(page)).toContain('default = "Talus cover"');
  await name.fill('Scree above the road');
  await name.press('Tab');
  await like.selectOption('bedrock_outcrops');
  await expect.poll(() => projectText(page)).toContain('name = "Scree above the road"\nlike = "bedrock_outcrops"');
});
