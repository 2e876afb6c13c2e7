package badlog.window.topics

import badlog.core.analysis.LogView
import badlog.formats.wpilog.largeLog
import badlog.formats.wpilog.parseLog
import badlog.window.log.OpenRecording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import java.nio.file.Path

class LargeLogSpec : FunSpec({
    val large by lazy { OpenRecording(Path.of("large.wpilog").toAbsolutePath(), LogView.of(parseLog(largeLog()))) }

    test("a log of more than 700 topics begins with at most 60 graphs, modules and axes together, and lists all its topics") {
        large.view.recording.topics.size shouldBeGreaterThan 700
        val graphs = large.standardGraphs.graphs
        graphs.size shouldBeLessThanOrEqual 60
        graphs.map { it.title } shouldContain "Chassis/Module speeds"
        large.signals.size + large.empty.size shouldBe large.view.recording.topics.size
    }
})
