// Minifies the compiled script of a page.
// Arguments: the folder of npm's modules, the script, the file to write.
const { readFileSync, writeFileSync } = require('node:fs')
const [modules, script, output] = process.argv.slice(2)
const { minifySync } = require(`${modules}/@swc/core`)

const { code } = minifySync(readFileSync(script, 'utf8'), {
    ecma: 2020,
    module: false,
    toplevel: true,
    compress: { passes: 4, toplevel: true },
    // Shortens the names that Kotlin's compiler gives to members, all of which end so, and which nothing outside this script uses;
    // docs/decisions/page-build.md.
    mangle: { toplevel: true, props: { regex: '(_1|_k\\$?)$' } },
    format: { comments: false },
})
writeFileSync(output, code)
