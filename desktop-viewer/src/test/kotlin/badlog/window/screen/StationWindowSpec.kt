package badlog.window.screen

import badlog.window.putPair
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir

@Tags("InCheck")
class StationWindowSpec : FunSpec({
    test("a line above the graphs offers the Driver Station's log of the match, and a click draws its topics").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val log = putPair(tempdir().toPath())
        RealWindow(tempdir().toPath(), log).use { window ->
            window.awaitText("Driver Station log found: 2026_03_07 10_04_05 Sat (± 0.02 s).")
            window.awaitGraphs()
            window.picture("station-offer")
            window.click("Show its link, power and messages with this log, and use them in rules")
            window.awaitState("the topics of both") { it.current.recording?.signal("Driver Station/Trip Time") != null }
            window.awaitState("what rules find in both") { it.findings.state.topics.contains("Driver Station/Battery Voltage") }
            window.awaitGraphs()
            window.picture("station-shown")
        }
    }
})
