package badlog.window.folder

import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.putSamples
import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.rules.Finding
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.shown.folder.Changes
import badlog.viewer.state.Action
import badlog.viewer.state.FindingRequest
import badlog.window.app.Viewer
import badlog.window.log.OpenRecording
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

class SinceLastMatchSpec : FunSpec({
    test("a difference is shown over the previous match") {
        val home = tempdir().toPath()
        val folder = tempdir().toPath().also { it.putSamples() }
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val summary = LogSummary(date = LogDate(0, DateSource.VALUES), content = Content.SOMETHING)
        val before = LogEntry(LogFile(folder.resolve("practice.bag"), 1, 1), summary, FindingSummary(0, emptyList()))
        val open = OpenRecording.read(folder.resolve("qualification-42.bag"))
        onWindowThread {
            viewer.show(open)
            val hot = Finding("Unlike other matches", Severity.WARNING, "Arm/Angle", "The arm was hot.", Double.NaN, emptyList(), 1, "")
            viewer.since.change { Changes(listOf(hot), mapOf(hot to before)) }
            viewer.store.send(Action.Ask(FindingRequest.Compare(hot)))
            awaitState { viewer.compared.state.loaded.isNotEmpty() }
            viewer.compared.state.checked shouldBe listOf(before.file)
            viewer.board.evidence.graphs.shouldHaveSize(1).single().lines.first() shouldBe "Arm/Angle"
        }
    }
})
