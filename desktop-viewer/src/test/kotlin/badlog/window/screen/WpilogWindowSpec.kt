package badlog.window.screen

import badlog.catalog.folder.loggedTexts
import badlog.catalog.folder.loggedTopic
import badlog.catalog.folder.wpilogOf
import badlog.core.recording.Value
import badlog.formats.wpilog.largeLog
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Files

@Tags("InCheck")
class WpilogWindowSpec : FunSpec({
    test("a log of 700 topics begins with closed folders and few graphs; one search and one click compare target and actual speed").config(enabledOrReasonIf = { needsDisplay }) {
        val file = Files.createDirectories(tempdir().toPath().resolve("Mill Creek")).resolve("FRC_20240316_104100.wpilog")
        Files.write(file, largeLog())
        val speeds = listOf("/Chassis/ActualFrontLeftModuleState/speed", "/Chassis/TargetFrontLeftModuleState/speed")
        RealWindow(tempdir().toPath(), file, width = 1366, height = 768).use { window ->
            window.awaitText("Folder Chassis")
            window.look { it.topics.state.folded.contains("Chassis") } shouldBe true
            window.awaitGraphs()
            window.picture("large-log", guide = "viewer-large")
            window.press(KeyEvent.VK_F, KeyEvent.VK_CONTROL)
            window.type("frontleft speed")
            window.awaitState("the search") { it.topics.state.query == "frontleft speed" }
            window.click("Topic ${speeds[0]}")
            window.awaitState("both in one graph, in sight") { viewer ->
                viewer.board.state.graphs.find { it.lines == speeds }?.let { it.id in viewer.board.inSight.orEmpty() } == true
            }
            window.awaitGraphs()
            val title = window.look { viewer -> viewer.board.state.graphs.first { it.lines == speeds }.title }
            window.point("Plot $title", 0.5, 0.5)
            window.awaitGraphs()
            window.picture("large-compare")
        }
    }

    test("a WPILOG is shown like a bag, and followed while it grows").config(enabledOrReasonIf = { needsDisplay }) {
        val values = listOf(Value("Event Name", "OHCL"), Value("Match Number", "7"), Value("Match Type", "Qualification"))
        fun bytes(seconds: Int) = wpilogOf(
            listOf(
                loggedTopic("DS:enabled", 0.0 to 0.0, 5.0 to 1.0, 20.0 to 0.0, unit = "ul"),
                loggedTopic("/System/Battery Voltage", *List(seconds * 10) { it / 10.0 to 12.5 - it % 70 / 50.0 }.toTypedArray()),
                loggedTopic("NT:/Tuning/kP", 0.5 to 0.02, 11.0 to 0.05, 17.0 to 0.04, unit = "ul"),
                loggedTexts("/Arm/State", 0.0 to "stowed", 6.0 to "scoring", 9.0 to "stowed"),
            ),
            values,
        )
        val file = tempdir().resolve("FRC_TBD.wpilog").toPath()
        Files.write(file, bytes(24))
        RealWindow(tempdir().toPath(), file).use { window ->
            window.awaitText("OHCL Qualification 7")
            window.look { viewer -> viewer.current.recording?.enabled?.map { it.span.from to it.span.to } } shouldBe listOf(5.0 to 20.0)
            window.awaitState("its graphs") { it.board.state.graphs.size == 4 }
            window.picture("wpilog")
            Files.write(file, bytes(30))
            window.awaitState("the rest of the log") { it.view.viewport.visible.to > 29 }
        }
    }
})
