package badlog.window.screen

import badlog.window.theme.Theme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Path
import kotlin.math.abs

@Tags("InCheck")
class FindingsWindowSpec : FunSpec({
    test("two clicks show the causes of a brownout, all of them on the screen of a small laptop").config(enabledOrReasonIf = { needsDisplay }) {
        RealWindow(tempdir().toPath(), Path.of("../samples/qualification-42.bag"), width = 1366, height = 768).use { window ->
            window.awaitState("its findings") { viewer -> viewer.findings.state.list?.all?.any { it.rule == "Browned out" } == true }
            window.awaitGraphs()
            window.click(window.look { viewer -> "Findings: ${viewer.findings.state.list?.all?.size}" })
            window.click("Finding, error: Browned out")
            window.awaitState("the brownout") { viewer -> viewer.view.cursor?.let { abs(it - 93.7096) < 1e-3 } == true }
            window.awaitState("what shows it, all on the screen") { viewer -> viewer.board.inSight.orEmpty().containsAll(viewer.board.evidence.graphs.map { it.id }) }
            window.look { viewer -> viewer.board.evidence.graphs.flatMap { it.lines } } shouldContainAll
                listOf("System/Battery Voltage", "PDP/Total Current", "Drivetrain/Left Output")
            window.awaitGraphs()
            window.picture("evidence", guide = "viewer-findings")
            window.look { viewer -> viewer.settings.change { copy(theme = Theme.DARK) } }
            window.awaitGraphs()
            window.picture("evidence-dark", guide = "viewer-dark")
        }
    }

    test("a brownout is reported without a click, and a formula over it stays").config(enabledOrReasonIf = { needsDisplay }) {
        val home = tempdir().toPath()
        val match = Path.of("../samples/qualification-42.bag")
        RealWindow(home, match).use { window ->
            window.awaitState("the match") { it.current.recording != null }
            window.awaitGraphs()
            window.awaitState("its findings") { viewer -> viewer.findings.state.list?.all?.any { it.rule == "Browned out" } == true }
            window.press(KeyEvent.VK_5, KeyEvent.VK_CONTROL)
            window.awaitText("Finding, error: Browned out")
            window.press(KeyEvent.VK_N)
            window.awaitState("the first finding") { it.findings.selected != null && it.view.cursor == it.findings.state.list?.incidents?.first()?.first?.time }
            window.press(KeyEvent.VK_N)
            window.press(KeyEvent.VK_N, KeyEvent.VK_SHIFT)
            window.click("Finding, error: Browned out")
            window.awaitState("the brownout") { viewer -> viewer.view.cursor?.let { abs(it - 93.7096) < 1e-3 } == true }
            repeat(6) { window.press(KeyEvent.VK_EQUALS) }
            window.awaitText("error: Browned out")
            window.awaitGraphs()
            window.picture("findings")
            window.press(KeyEvent.VK_1, KeyEvent.VK_CONTROL)
            window.awaitText("Search events")
            window.picture("brownout", guide = "viewer-recording")

            window.click("Plot Battery and current")
            window.press(KeyEvent.VK_F)
            window.awaitText("Formula sheet")
            window.type("twice = battery vol")
            window.awaitText("Insert System/Battery Voltage")
            window.press(KeyEvent.VK_TAB)
            window.press(KeyEvent.VK_ENTER)
            window.awaitState("the formula") { it.current.recording?.signal("twice") != null && it.formulas.sheet == null }
            window.awaitText("Plot twice")
            window.awaitGraphs()
            window.picture("formula")
        }
        RealWindow(home, match).use { window ->
            window.awaitState("the formula of last time") { it.current.recording?.signal("twice") != null }
            // A log is open for a moment before its last layout is applied.
            window.awaitState("its graph") { viewer -> viewer.board.state.graphs.lastOrNull()?.lines?.singleOrNull() == "twice" }
            window.look { it.current.recording }.shouldNotBeNull().formulas.single().error shouldBe null
        }
    }
})
