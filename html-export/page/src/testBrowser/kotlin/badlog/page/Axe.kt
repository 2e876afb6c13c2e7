package badlog.page

private val SOURCE: String by lazy {
    val script = OpenPage::class.java.getResource("/badlog/axe.min.js")
    checkNotNull(script) { "axe-core is not among the resources of the tests." }.readText()
}

/** Returns the violations in the current page that axe-core considers serious or worse: each rule with its elements. */
internal fun OpenPage.seriousForReaders(): List<String> {
    driver.executeScript(SOURCE)
    val found = driver.executeAsyncScript(
        """
        const done = arguments[arguments.length - 1];
        axe.run(document, { resultTypes: ['violations'] }).then(result => done(result.violations
            .filter(rule => rule.impact === 'serious' || rule.impact === 'critical')
            .map(rule => rule.id + ': ' + rule.nodes.slice(0, 5).map(node => node.target + ' ' + (node.any[0]?.message ?? '')).join(' | '))
        ), problem => done(['axe failed: ' + problem]));
        """.trimIndent(),
    )
    return (found as List<*>).map { it.toString() }
}
