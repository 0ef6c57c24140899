// SPDX-License-Identifier: GPL-3.0-or-later
// What people do on the page.

export const state = (page) => page.evaluate(() => window.arcbid.state());
export const drawn = (page) => page.evaluate(() => window.arcbid.drawn());
export const seek = (page, t, track = 'auction') => page.evaluate(([to, on]) => window.arcbid.seek(to, on), [t, track]);

export async function press(page, key) {
  await page.keyboard.press(key);
  await drawn(page);
}

export async function mostOwned(page) {
  const { owners } = await state(page);
  return { owned: owners.filter((owner) => owner >= 0).length };
}

/** Clicks the first piece, from `from` on, that no other hides and that has something to say; returns its id. */
export async function clickPiece(page, from = 0) {
  const { tasks } = await page.evaluate(() => window.arcbid.counts());
  for (let slot = from; slot < tasks; slot++) {
    const at = await page.evaluate((one) => window.arcbid.find(one), slot);
    if (at?.slot !== slot || !(await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.id === 'scene', [at.x, at.y]))) continue;
    await page.mouse.click(at.x, at.y);
    await drawn(page);
    return (await state(page)).task ?? undefined;
  }
  return undefined;
}

/** The picture alone, without text: letters differ from machine to machine. */
export async function picture(page) {
  await drawn(page);
  const url = await page.evaluate(() => document.getElementById('scene').toDataURL('image/png'));
  return Buffer.from(url.split(',')[1], 'base64');
}
