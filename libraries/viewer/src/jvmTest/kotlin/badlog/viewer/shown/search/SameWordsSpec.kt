package badlog.viewer.shown.search

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.RuleSet
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import badlog.viewer.shown.finding.findsFound
import badlog.viewer.shown.finding.searchedText
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

private val ROOT = generateSequence(File("").absoluteFile) { it.parentFile }.first { File(it, "docs/glossary.md").exists() }

class SameWordsSpec : FunSpec({
    test("the glossary lists the words that find each other") {
        val listed = File(ROOT, "docs/glossary.md").readLines().filter { it.startsWith("- `") }
        listed.map { line -> line.removePrefix("- ").split(", ").map { it.trim('`') } } shouldBe SAME_WORDS
    }

    test("an incident is found by each of its findings, even ones that its description omits") {
        val units = mapOf("Time" to "s", "System/Battery Voltage" to "V", "System/Browned Out" to "ul", "PDP/Total Current" to "A", "PDP/Current 0" to "A")
        val topics = units.map { (name, unit) -> """{"name":"$name","unit":"$unit","attrs":[${if (unit == "s") "\"xaxis\"" else ""}]}""" }
        val rows = List(1500) { "${it / 50.0}," + if (it in 500..700) "6.5,true,240,60" else "12.2,false,10,3" }
        val text = listOf("""{"topics":$topics,"values":[]}""", units.keys.joinToString(",")) + rows
        val view = LogView.of(BagParser().apply { accept(text.joinToString("\n", postfix = "\n").encodeToByteArray()) }.finish())
        val incident = RuleSet.BUILT_IN_PROVEN.run { incidentsIn(over(view, "test.bag").findings) }.first()
        for (query in listOf("brownout", "battery", "\"too much at once\"")) Query(query).findsFound(incident.searchedText) shouldBe true
        Query("gearbox").findsFound(incident.searchedText) shouldBe false
    }
})
