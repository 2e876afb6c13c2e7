package badlog.window.screen

import badlog.catalog.folder.samples
import badlog.core.analysis.LogView
import badlog.fetch.RobotAddress
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.networktables.replay.ReplayOptions
import badlog.networktables.replay.ReplayServer
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.awt.event.KeyEvent
import java.nio.file.Files

@Tags("InCheck")
class RecordingWindowSpec : FunSpec({
    test("two clicks record a running robot and show its newest moment, and a key marks that").config(enabledOrReasonIf = { needsDisplay }) {
        val match = LogView.of(readRecording(samples.resolve("qualification-42.bag"), LOG_FORMATS)).withSignals(RuleSet.BUILT_IN.signals, "qualification-42.bag")
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek"))
        ReplayServer(match, ReplayOptions(0, speed = 4.0, isLooping = true)).use { server ->
            server.start()
            val robots = { _: String -> listOf(RobotAddress("127.0.0.1", emptyList(), networkTablesPort = server.port)) }
            RealWindow(tempdir().toPath(), folder, robots = robots).use { window ->
                window.awaitState("a look at the folder") { it.library.state.hasLooked }
                window.click("Logs from the robot")
                window.look { viewer -> viewer.settings.change { copy(robot = "1014") } }
                window.click("Record what the robot publishes")
                window.click("Record until stopped")
                window.awaitState("the log that is recorded, live") { it.current.recording != null && it.live.isStaying }
                window.awaitText("Stop recording")
                window.awaitState("more of it") { it.current.recording!!.span.width > 2 }
                window.press(KeyEvent.VK_M, KeyEvent.VK_SHIFT)
                window.awaitState("a mark") { viewer -> viewer.notes.all.any { it.text == "Mark 1" } }
                window.picture("recording-live")
                window.click("Stop recording")
                window.awaitSaid(" is recorded: ")
            }
        }
    }
})
