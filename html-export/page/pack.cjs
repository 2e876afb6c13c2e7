// Packs the style sheet and the script of a page into one gzip stream.
// Arguments: the folder of npm's modules, the style sheet, the script, the file to write.
const { readFileSync, writeFileSync } = require('node:fs')
const [modules, style, script, output] = process.argv.slice(2)
const { gzip } = require(`${modules}/@gfx/zopfli`)

const text = Buffer.concat([readFileSync(style), Buffer.from([0]), readFileSync(script)])
gzip(text, { numiterations: 5 }, (problem, packed) => {
    if (problem) throw problem
    writeFileSync(output, packed)
})
