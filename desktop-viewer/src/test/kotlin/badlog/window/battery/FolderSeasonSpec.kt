package badlog.window.battery

import badlog.catalog.folder.LogEntry
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.window.app.Viewer
import badlog.window.sidebar.MainView
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

class FolderSeasonSpec : FunSpec({
    fun entry(folder: Path, match: Int, battery: String?, milliohms: Double) = LogEntry(
        LogFile(folder.resolve("q$match.bag"), 1000, 1000L * match),
        LogSummary(
            MatchOfLog(type = "Qualification", number = "$match"),
            LogDate(7200L * match, DateSource.VALUES),
            content = Content.SOMETHING,
            battery = BatteryUse(battery, "Battery", 8.5, 12.8, null, null, Resistance(milliohms, 0.4)),
        ),
    )

    test("a battery named for a match is stored beside its log, and listed") {
        val folder = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(folder, folder))
        val used = listOf("B2" to 30.0, "B2" to 30.0, null to 21.0, "A1" to 20.0, "A1" to 20.2)
        val logs = used.mapIndexed { i, (battery, milliohms) -> entry(folder, i + 1, battery, milliohms) }
        onWindowThread {
            val following = launch { viewer.batteries.run() }
            viewer.library.change { copy(folder = folder, hasLooked = true, files = logs.map { it.source }).withEntries(logs) }
            viewer.panels.change { copy(main = MainView.BATTERIES) }
            awaitState { viewer.batteries.state.seasons.size == 3 }

            fun third() = viewer.batteries.state.seasons.flatMap { it.matches }.single { match -> match.paths.any { "q3" in it } }
            viewer.batteries.assign("C3", third())
            awaitState { viewer.batteries.state.names == listOf("A1", "B2", "C3") }
            Files.readString(folder.resolve("batteries.toml")) shouldBe "[used]\n\"q3.bag\" = \"C3\"\n"
            viewer.batteries.assign("b2", third())
            awaitState { viewer.batteries.state.names == listOf("A1", "B2") }
            Files.readString(folder.resolve("batteries.toml")) shouldBe "[used]\n\"q3.bag\" = \"B2\"\n"
            following.cancel()
        }
    }
})
