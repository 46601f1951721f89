// Bundles src/ into one HTML file, the template that `sundrape_postproc view` puts a result into.
import { build } from 'esbuild';
import { readFile, writeFile } from 'node:fs/promises';

const here = new URL('./', import.meta.url);
const output = new URL('../sundrape_postproc/viewer.html', here);
const marks = { title: '<!-- sundrape: title -->', data: '<!-- sundrape: data -->' };

const bundled = await build({
  entryPoints: [new URL('src/app.js', here).pathname],
  bundle: true,
  minify: true,
  treeShaking: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'inline', // the licences of what is bundled stay with it
  write: false,
  logLevel: 'warning',
});
const styles = await build({
  entryPoints: [new URL('src/page.css', here).pathname],
  minify: true,
  write: false,
  logLevel: 'warning',
});
// What would end the element early or be taken for a mark is written otherwise, with the same meaning in JavaScript.
const script = bundled.outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

const licence = (await readFile(new URL('node_modules/three/LICENSE', here), 'utf8')).replaceAll('--', '- -').trim();

const parts = { '/* page.css */': styles.outputFiles[0].text, '/* app.js */': script, '(licence)': licence };
let page = await readFile(new URL('src/page.html', here), 'utf8');
for (const mark of Object.values(marks)) {
  if (page.split(mark).length !== 2) throw new Error(`src/page.html must have ${mark} once`);
}
for (const [mark, text] of Object.entries(parts)) {
  if (page.split(mark).length !== 2) throw new Error(`src/page.html must have ${mark} once`);
  page = page.replace(mark, () => text);
}
for (const mark of Object.values(marks)) {
  if (page.split(mark).length !== 2) throw new Error(`${mark} must not be in the sources`);
}
await writeFile(output, page);
console.log(`viewer.html: ${(page.length / 1024).toFixed(0)} KiB`);
