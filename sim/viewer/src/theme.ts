// SPDX-License-Identifier: GPL-3.0-or-later
// Light, dark, or as the system has it.
import type { App } from './app';

export type Theme = 'system' | 'light' | 'dark';
const ORDER: Theme[] = ['system', 'light', 'dark'];

export class ThemeSwitch {
  theme: Theme = 'system';
  private readonly system = matchMedia('(prefers-color-scheme: dark)');

  constructor(private readonly app: App, private readonly told: (theme: Theme) => void) {
    this.system.addEventListener('change', () => this.apply());
  }

  next(): void { this.set(ORDER[(ORDER.indexOf(this.theme) + 1) % ORDER.length]); }

  set(theme: Theme): void {
    this.theme = theme;
    this.apply();
  }

  apply(): void {
    const dark = this.theme === 'dark' || (this.theme === 'system' && this.system.matches);
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    this.app.dark = dark;
    this.app.scene.setTheme(dark);
    this.told(this.theme);
    this.app.changed();
  }
}
