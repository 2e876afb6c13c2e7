package badlog.window.sidebar

import badlog.viewer.panel.folder.AcrossLog
import badlog.viewer.shown.search.Query
import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class AcrossSourceSpec : FunSpec({
    test("a drawn log of the folder has one row, with the folder's date and all its signals") {
        fun log(label: String, path: String, topic: String): AcrossLog {
            val row = acrossLog(recordingOf(bagOf(listOf("Time|xaxis", topic), listOf("0,7")), path), listOf(topic), "")
            return AcrossLog(label, "2026-03-14 10:41", path, row.statistics, row.units)
        }
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A|delta", "Mode"), listOf("0,1,on", "1,4,on")), "open.bag")
        val source = acrossSource(listOf(open), listOf(log("open", "${open.file}", "A"), log("none", "none.bag", "A"), log("d", "d.bag", "Z")))
        source.topics shouldContainExactly listOf("A", "A Delta", "Z")
        source.topicsFoundBy(Query("has:finding | is:constant"), setOf("A")) shouldContainExactly listOf("A")
        source.topicsFoundBy(Query("is:number -has:finding"), setOf("A")) shouldContainExactly listOf("A Delta", "Z")
        val made = source.logsOf(listOf("A", "A Delta"))
        made.map { it.label } shouldContainExactly listOf("open.bag", "none", "d")
        made[0].date shouldBe "2026-03-14 10:41"
        made[0].statistics.keys shouldBe setOf("A", "A Delta")
    }
})
