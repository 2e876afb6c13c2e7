package badlog.window.compare

import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.recordingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

class ComparedRecordingsSpec : FunSpec({
    val home = tempdir().toPath()
    fun file(name: String, text: String): Path = home.resolve(name).also { Files.writeString(it, text) }

    val open = recordingOf("Time,A\n0,1\n1,2\n", home.resolve("open.bag").toString())
    val other = file("other.bag", "Time,A\n0,3\n1,9\n")

    fun viewerOf() = Viewer(MainScope(), UserFolders(home, home)).also { it.current.replace(open) }

    suspend fun <T> onWindow(action: () -> T): T = withContext(Dispatchers.Swing) { action() }

    test("a checked recording is read and drawn after the open one, until it is unchecked") {
        val viewer = onWindow { viewerOf() }
        onWindow { viewer.compared.toggle(other) }
        eventually(60.seconds) { onWindow { viewer.compared.drawn.map { it.recording.file } } shouldContainExactly listOf(open.file, other) }
        onWindow { viewer.compared.toggle(other) }
        onWindow { viewer.compared.state } shouldBe Comparison()
    }

    test("the open recording can be checked without being read again, and is drawn once") {
        val viewer = onWindow { viewerOf() }
        onWindow {
            viewer.compared.toggle(open.file)
            viewer.tasks.all.isEmpty() shouldBe true
            viewer.compared.state.loaded[open.file] shouldBe open
            viewer.compared.drawn shouldBe listOf(DrawnRecording(open))
        }
    }

    test("an unreadable recording is reported and unchecked") {
        val viewer = onWindow { viewerOf() }
        onWindow {
            viewer.compared.toggle(home.resolve("missing.bag"))
            viewer.compared.toggle(file("picture.bag", "\u0089PNG\r\n\u001a\n\u0000\u0000"))
        }
        eventually(60.seconds) {
            onWindow { viewer.compared.state.checked } shouldBe emptyList()
            onWindow { viewer.notices.all.map { it.isError } } shouldBe listOf(true, true)
        }
    }
})
