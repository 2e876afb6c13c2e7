package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.shown.search.Query
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SearchedTextSpec : FunSpec({
    test("a finding is searched by its rule, its severity and its text, and all of them match has:finding") {
        val text = Finding("Browned out", Severity.ERROR, null, "Motors were switched off.", 1.0, emptyList(), 1, "s").searchedText
        for (query in listOf("brown", "ERROR motors", "note | error", "-warning", "has:finding")) Query(query).findsFound(text) shouldBe true
        for (query in listOf("warning", "brown -error", "-has:finding")) Query(query).findsFound(text) shouldBe false
    }

    test("a search reports the numbers of hidden incidents and findings, and nothing if it hides none") {
        hiddenBySearch(0, 0) shouldBe ""
        hiddenBySearch(1, 0) shouldBe "1 incident hidden by the search."
        hiddenBySearch(0, 2) shouldBe "2 findings hidden by the search."
        hiddenBySearch(2, 1_200) shouldBe "2 incidents and 1200 findings hidden by the search."
    }
})
