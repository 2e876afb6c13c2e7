package badlog.viewer.recording

import badlog.viewer.bagOf
import badlog.viewer.graph.viewerOf
import badlog.viewer.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

class RecordingFollowingSpec : FunSpec({
    val file = tempdir().resolve("live.bag").apply { writeText("x") }
    val shown = recordingOf(bagOf(listOf("Time|xaxis", "A/Voltage"), listOf("0,1", "1,2")), file.path)
    val before = FileStamp(size = 1, modifiedMillis = 0)

    test("a log that outgrows the memory stays as it was, and that is said once") {
        val viewer = viewerOf(shown)
        val following = RecordingFollowing(viewer) { _, _ -> throw OutOfMemoryError() }
        withContext(Dispatchers.Main) { following.follow(shown, before) }
        viewer.notices.all.single().text shouldContain "larger than the memory"
        viewer.open shouldBe shown
    }

    test("a log that is gone when it is to be read again stays, and that is said once") {
        val viewer = viewerOf(shown)
        val following = RecordingFollowing(viewer) { _, _ ->
            file.delete()
            throw IOException("It is gone.")
        }
        withContext(Dispatchers.Main) { following.follow(shown, before) }
        viewer.notices.all.single().text shouldContain "is gone from its folder"
        viewer.open shouldBe shown
    }
})
