// Minifies the compiled script of a page.
// Arguments: the folder of npm's modules, the script, the file to write.
const { readFileSync, writeFileSync } = require('node:fs')
const [modules, script, output] = process.argv.slice(2)
const { minifySync } = require(`${modules}/@swc/core`)

const source = readFileSync(script, 'utf8')
const options = { ecma: 2020, module: false, toplevel: true, format: { comments: false } }

// The minifier shortens a member's name only if it has seen the member declared in some place: this class, which is then removed, has all.
const names = new Set(source.match(/(?<=\.)[\w$]+(_1|_k\$?)(?![\w$])/g))
const declared = `${source};class Names{${[...names].map(name => `${name}(){}`).join('')}}`

// Shortens the names that Kotlin's compiler gives to members, all of which end so, and which nothing outside this script uses;
// docs/decisions/page-build.md.
const shortened = minifySync(declared, { ...options, compress: false, mangle: { toplevel: false, props: { regex: '(_1|_k\\$?)$' } } })

// Functions in one place, and comparisons, loops and variables as they were written, repeat more, which packs better.
const compress = { passes: 4, toplevel: true, hoist_funs: true, comparisons: false, loops: false, collapse_vars: false }
writeFileSync(output, minifySync(shortened.code, { ...options, compress, mangle: { toplevel: true } }).code)
