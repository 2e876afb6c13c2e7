package badlog.viewer.choices.board

import badlog.signals.pose.posesOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.draw.path.poseTopics
import badlog.viewer.shown.search.Query
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PathBoardSpec : FunSpec({
    test("a log with poses begins with the driven and the planned path") {
        val view = timedView(*(poseTopics("Drive/Target Pose") + poseTopics("Drive/Pose") + timedTopic("Volts", 0.0 to 1.0, 1.0 to 2.0)).toTypedArray())
        val graph = pathBoard(view).graphs.single()
        graph.isXy shouldBe true
        graph.lines shouldBe listOf("Pose", "Target Pose").flatMap { listOf("Drive/$it/translation/x", "Drive/$it/translation/y") }
        standardBoard(view, SignalVocabulary.NONE).graphs.map { it.title }.take(2) shouldBe listOf("Path", "Volts")
    }

    test("a search offers the path of a pose by its name and the word path, and the elements of an array as one") {
        val view = timedView(*(poseTopics("Drive/Target Pose") + poseTopics("Drive/Pose") + poseTopics("Tags[0]") + poseTopics("Tags[1]")).toTypedArray())
        val poses = posesOf(view.recording.topics)
        pathGraphs(poses, Query("")) shouldBe emptyList()
        pathGraphs(poses, Query("drive path")).map { it.title } shouldBe listOf("Path of Drive/Target Pose", "Path of Drive/Pose")
        val found = pathGraphs(poses, Query("target")).single()
        found.isXy shouldBe true
        found.lines shouldBe listOf("Drive/Target Pose/translation/x", "Drive/Target Pose/translation/y")
        pathGraphs(poses, Query("tags")).single().lines.size shouldBe 4
        pathGraphs(poses, Query("voltage")) shouldBe emptyList()
    }

    test("a log without a driven path, or of a robot that stood still, has no path") {
        pathBoard(timedView(*poseTopics("Vision/Pose").toTypedArray())) shouldBe Board()
        val still = poseTopics("Pose").map { it.copy(samples = DoubleArray(2)) }
        pathBoard(timedView(*still.toTypedArray())) shouldBe Board()
    }
})
