package badlog.window.findings

import badlog.core.recording.Severity
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

    test("what is of the whole log comes first, the others by time") {
        list.all.map { it.rule } shouldContainExactly listOf("Whole", "Early", "Middle", "Late")
        list.timeline.places.map { it.finding.rule } shouldContainExactly listOf("Early", "Middle", "Late")
        list.worst shouldBe Severity.ERROR
        list.skipped.single().rule shouldBe "Missing"
        list.foundBy("").counts shouldBe "2 errors, 1 warning, 1 note"
    }

    test("each mark of a finding leads to its own place, and what lies between two of them to the nearer one") {
        val often = tempdir().toPath().also { writeRules(it, ruleText("Often", "B > 0.5"), ruleText("Whole", "mean(A) > 10")) }
        val found = findingsIn(counted(often))
        val finding = found.all.single { it.rule == "Often" }
        found.timeline.places.map { found.placeNear(finding, it.span.from) } shouldContainExactly List(10) { it * 10.0 }
        found.placeNear(finding, 43.0) shouldBe 40.0
        found.placeNear(finding, 48.0) shouldBe 50.0
        found.placeNear(finding, 1e6) shouldBe 90.0
        found.placeNear(found.all.single { it.rule == "Whole" }, 43.0).isNaN() shouldBe true
    }
})
