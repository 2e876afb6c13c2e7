package badlog.viewer.findings

import badlog.analysis.Span
import badlog.recording.Severity
import badlog.viewer.graph.coveredPixels
import badlog.viewer.graph.findingAt
import badlog.viewer.inspector.summaryOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class FindingListSpec : FunSpec({
    val folder = tempdir().toPath()
    writeRules(
        folder,
        ruleText("Late", "A > 80", "note"),
        ruleText("Whole", "mean(A) > 10", "error"),
        ruleText("Early", "A > 20 and A < 30", "error"),
        ruleText("Middle", "A > 50"),
        ruleText("Missing", "C > 5"),
    )
    val list = findingsIn(counted(folder))
    fun named(name: String) = list.all.single { it.rule == name }

    test("what is of the whole log comes first, the others by time") {
        list.all.map { it.rule } shouldContainExactly listOf("Whole", "Early", "Middle", "Late")
        list.placed.map { it.rule } shouldContainExactly listOf("Early", "Middle", "Late")
        list.worst shouldBe Severity.ERROR
        list.skipped.single().rule shouldBe "Missing"
        summaryOf(list) shouldBe "2 errors, 1 warning, 1 note"
    }

    test("steps go on from the one of before, else from the cursor, and stay at the ends") {
        list.stepped(1, from = null, x = null)?.rule shouldBe "Early"
        list.stepped(-1, from = null, x = null)?.rule shouldBe "Late"
        list.stepped(1, named("Early"), x = 29.0)?.rule shouldBe "Middle"
        list.stepped(-1, named("Middle"), x = 51.0)?.rule shouldBe "Early"
        list.stepped(1, from = null, x = 40.0)?.rule shouldBe named("Middle").rule
        list.stepped(-1, from = null, x = 40.0)?.rule shouldBe "Early"
        list.stepped(1, named("Late"), x = 99.0)?.rule shouldBe "Late"
        list.stepped(-1, from = null, x = 5.0)?.rule shouldBe "Early"
        FindingList().stepped(1, null, null) shouldBe null
    }

    test("the pixels at which a finding holds are of the worst that does") {
        val runs = coveredPixels(list.placed, Span(0.0, 100.0), 100)
        runs.map { Triple(it.from, it.until, it.severity) } shouldContainExactly listOf(
            Triple(21, 31, Severity.ERROR),
            Triple(51, 100, Severity.WARNING),
        )
        coveredPixels(list.placed, Span(0.0, 10.0), 100) shouldBe emptyList()
        coveredPixels(list.placed, Span(0.0, 100.0), 0) shouldBe emptyList()
    }

    test("the mark nearest to a place is found, else what holds there") {
        val all = Span(0.0, 100.0)
        val middle = named("Middle").time
        findingAt(list.placed, middle + 0.5, reach = 1.0, all)?.rule shouldBe "Middle"
        findingAt(list.placed, 25.0, reach = 0.1, all)?.rule shouldBe "Early"
        findingAt(list.placed, 5.0, reach = 1.0, all) shouldBe null
        findingAt(list.placed, 70.0, reach = 1.0, Span(60.0, 75.0))?.rule shouldBe "Middle"
    }
})
