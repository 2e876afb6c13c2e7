package badlog.window.log

import badlog.catalog.folder.loggedTopic
import badlog.catalog.folder.wpilogOf
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.graph.viewerOf
import badlog.window.recordingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.cancel
import kotlinx.coroutines.withContext
import kotlinx.coroutines.withTimeout
import java.io.IOException
import java.nio.file.Files
import kotlin.time.Duration.Companion.seconds

class RecordingWatcherSpec : FunSpec({
    val file = tempdir().resolve("live.bag").apply { writeText("x") }
    val shown = recordingOf(bagOf(listOf("Time|xaxis", "A/Voltage"), listOf("0,1", "1,2")), file.path)
    val before = FileStamp(size = 1, modifiedMillis = 0)

    listOf(
        "while it is read" to NotReadException(ReadResult.NotRead.of(shown.file, OutOfMemoryError())),
        "while it is prepared for the screen" to OutOfMemoryError(),
    ).forEach { (moment, failure) ->
        test("a log that outgrows the memory $moment stays as it was, is reported once, and is not read again") {
            val viewer = viewerOf(shown)
            var hasEnded = false
            val watcher =
                RecordingWatcher(viewer.notices, { _, _ -> throw failure }, { read, _ -> viewer.current.replace(read) }, { hasEnded = true })
            withTimeout(60.seconds) { withContext(Dispatchers.Main) { watcher.watch(shown, before) } }
            val text = viewer.notices.all.single().text
            text shouldContain "${shown.file} does not fit into"
            text shouldContain "The data read so far stays open."
            viewer.current.recording shouldBe shown
            hasEnded shouldBe true
        }
    }

    test("a log that is missing when it is read again stays open, and is reported once") {
        val viewer = viewerOf(shown)
        val gone = { _: OpenRecording, _: Boolean ->
            file.delete()
            throw IOException("It is gone.")
        }
        val watcher = RecordingWatcher(viewer.notices, gone, { read, _ -> viewer.current.replace(read) })
        withContext(Dispatchers.Main) { watcher.watch(shown, before) }
        viewer.notices.all.single().text shouldContain "was removed from its folder"
        viewer.current.recording shouldBe shown
    }

    test("formulas are recalculated when a log has grown") {
        val home = tempdir().toPath()
        val file = home.resolve("growing.bag")
        fun bag(rows: Int) = bagOf(listOf("Time|xaxis", "A/Voltage"), List(rows) { "$it,$it" })
        Files.writeString(file, bag(3))
        val scope = CoroutineScope(Dispatchers.Main + Job())
        val viewer = Viewer(scope, UserFolders(home, home)).apply { formulas.replaceAll(listOf("Twice = 2 * A/Voltage")) }
        try {
            withContext(Dispatchers.Main) { viewer.loader.open(file) }
            eventually(60.seconds) { viewer.current.recording?.signal("Twice")?.series?.y?.last() shouldBe 4.0 }
            Files.writeString(file, bag(6))
            eventually(60.seconds) { viewer.current.recording?.signal("Twice")?.series?.y?.last() shouldBe 10.0 }
        } finally {
            scope.cancel()
        }
    }

    test("a growing WPILOG is followed, and half of a last record is not a problem meanwhile") {
        val home = tempdir().toPath()
        val whole = wpilogOf(listOf(loggedTopic("Gain", *List(100) { it * 1.0 to it * 2.0 }.toTypedArray())))
        val file = home.resolve("growing.wpilog")
        Files.write(file, whole.copyOf(whole.size / 2))
        val scope = CoroutineScope(Dispatchers.Main + Job())
        val viewer = Viewer(scope, UserFolders(home, home))
        fun size() = viewer.current.recording.shouldNotBeNull().view.recording.sampleCount
        try {
            withContext(Dispatchers.Main) { viewer.loader.open(file) }
            eventually(60.seconds) { size() }
            val before = size()
            // A file that is cut off ends inside a record.
            Files.write(file, whole.copyOf(whole.size - 3))
            eventually(60.seconds) {
                size() shouldBe 99
                viewer.current.recording.shouldNotBeNull().view.recording.problems.shouldBeEmpty()
            }
            (before in 1..98) shouldBe true
            eventually(60.seconds) { viewer.view.viewport.visible.to shouldBe 98.0 }
            Files.write(file, whole)
            eventually(60.seconds) { size() shouldBe 100 }
        } finally {
            scope.cancel()
        }
    }
})
