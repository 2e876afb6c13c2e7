package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.shown.search.Query
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class FindingSearchSpec : FunSpec({
    fun finding(rule: String, severity: Severity) = Finding(rule, severity, null, "$rule happened.", 1.0, emptyList(), 1, "s")

    val search = FindingSearch(
        listOf(finding("Browned out", Severity.ERROR), finding("Low battery", Severity.ERROR), finding("Browned again", Severity.NOTE)),
        emptyList(),
    )

    fun foundBy(text: String) = search.foundBy(Query(text))

    test("without a search, all findings are listed, and counted by severity") {
        foundBy(" ").findings shouldBe search.all
        foundBy("").beside.outside shouldBe search.all
        foundBy("").counts shouldBe "2 errors, 1 note"
        foundBy("").hidden shouldBe ""
    }

    test("a search reports the found part of all findings") {
        val found = foundBy("brown")
        found.findings.map { it.rule } shouldContainExactly listOf("Browned out", "Browned again")
        found.counts shouldBe "2 of 3: 1 error, 1 note"
        found.hidden shouldBe "1 finding hidden by the search."
        foundBy("no such thing").counts shouldBe "0 of 3"
    }

    test("without findings, the counts are empty") {
        FindingSearch(emptyList(), emptyList()).foundBy(Query("brown")).counts shouldBe ""
    }
})
