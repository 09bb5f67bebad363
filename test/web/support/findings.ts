// Findings of axe-core, which checks accessibility.

import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';

interface Finding {
  id: string;
  impact?: string | null;
  nodes: { html: string }[];
}
const texts = (list: readonly Finding[]) => list.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).join(' | ')}`);

async function violations(page: Page, within: string): Promise<Finding[]> {
  // In the page itself: the usual mode opens another one each time. The page has no frames.
  const axe = new AxeBuilder({ page }).setLegacyMode().include(within).options({ resultTypes: ['violations'] });
  return (await axe.analyze()).violations;
}

/// All of a part of the page.
export const findings = async (page: Page, within: string) => texts(await violations(page, within));

/// Those that are serious; a part of the page takes a part of the time.
export const seriousFindings = async (page: Page, within = 'html') =>
  texts((await violations(page, within)).filter(({ impact }) => impact === 'serious' || impact === 'critical'));
