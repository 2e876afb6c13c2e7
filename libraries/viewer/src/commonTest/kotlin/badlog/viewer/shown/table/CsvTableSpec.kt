package badlog.viewer.shown.table

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.viewer.bagView
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

class CsvTableSpec : FunSpec({
    fun textOf(table: CsvTable, block: Int = 7) = table.header + (0 until table.rowCount step block).joinToString("") { table.text(it, block) }

    fun linesOf(table: CsvTable) = textOf(table).trimEnd().lines()

    fun read(text: String): Recording = BagParser().run {
        accept(text.encodeToByteArray())
        finish()
    }

    fun textsOf(topic: Topic) = (0 until topic.texts.size).map { topic.texts.rows[it] to topic.texts[it] }

    val numbers = Arb.double()
    val texts = listOf("idle", "a, b", "say \"no\"", "x\ny", "1.5 V")
    val logs = arbitrary {
        List(Arb.int(1..30).bind()) { row ->
            val number = numbers.bind()
            val text = Arb.element(texts).bind()
            "$row,${if (number.isFinite()) number.toString() else ""},\"${text.replace("\"", "\"\"")}\",${Arb.element("true", "false").bind()}"
        }
    }

    test("a written table is read back as the same rows, each number to its last bit") {
        checkAll(logs) { rows ->
            val view = bagView(listOf("Time|xaxis", "A", "Mode", "On"), rows)
            val again = read(textOf(CsvTable.ofAll(view)))
            again.rowCount shouldBe rows.size
            again.topics.map { it.name.substringBefore(" (") } shouldContainExactly listOf("Time", "A", "Mode", "On")
                .filter { name -> view.recording.topics.first { it.name == name }.let { it.samples.isNotEmpty() || it.texts.size > 0 } }
            for (topic in again.topics) {
                val logged = view.recording.topics.first { it.name == topic.name.substringBefore(" (") }
                // The sign of zero is not kept.
                topic.samples.map { (it + 0.0).toBits() } shouldContainExactly logged.samples.map { (it + 0.0).toBits() }
                textsOf(topic) shouldContainExactly textsOf(logged)
            }
        }
    }

    test("a table that is prepared topic by topic is the same as one made at once") {
        val rows = listOf("0,1,2,3,idle", "1,2,3,4,", "2,3,4,5,shot")
        val view = bagView(listOf("Time|xaxis", "A", "B", "C", "Log|log"), rows)
        val own = timedView(timedTopic("A", 0.0 to 1.0, 0.1 to 2.0), timedTopic("B", 0.05 to 3.0))
        for ((log, topics) in listOf(view to 4, own to 2)) {
            val draft = CsvDraft.ofAll(log)
            val shares = ArrayList<Double>()
            while (draft.step()) shares += draft.share
            // Each topic is examined, and has a column.
            (shares.size > topics * 2 - 1) shouldBe true
            shares.all { it > 0 && it <= 1 } shouldBe true
            shares.last() shouldBe 1.0
            draft.step() shouldBe false
            textOf(draft.table) shouldBe textOf(CsvTable.ofAll(log))
        }
    }

    test("x is first, then each topic with its unit, only of the visible range") {
        val view = bagView(listOf("A", "Time|xaxis", "Log|log"), listOf("1,0,begun", "2,1,", "3,2,\"shot, missed\"", "4,3,"))
        linesOf(CsvTable.ofAll(view, Span(1.0, 2.0))) shouldContainExactly listOf("Time (V),A (V),Log", "1,2,", "2,3,\"shot, missed\"")
        linesOf(CsvTable.of(view, null, listOf(view.seriesOf(view.recording.topics[0])))) shouldContainExactly
            listOf("Time (V),A (V)", "0,1", "1,2", "2,3", "3,4")
        CsvTable.ofAll(view, Span(8.0, 9.0)).rowCount shouldBe 0
    }

    test("rows without x, or with damaged cells, are kept") {
        val view = bagView(listOf("Time|xaxis", "A"), listOf("0,1", ",2", "2,oops", "3,4"))
        linesOf(CsvTable.ofAll(view)) shouldContainExactly listOf("Time (V),A (V)", "0,1", ",2", "2,oops", "3,4")
    }

    test("topics with times of their own have a row every 20 ms, with the last values") {
        val view: LogView = timedView(timedTopic("Gain", 0.0 to 1.0, 0.05 to 2.0, 1.0 to 5.0), timedTopic("Late", 0.04 to 7.5))
        val table = CsvTable.ofAll(view, Span(0.0, 0.07))
        linesOf(table) shouldContainExactly listOf("Time (s),Gain (V),Late (V)", "0,1,", "0.02,1,", "0.04,1,7.5", "0.06,2,7.5")
        table.remark shouldBe ", one every 20 ms, each with the last values before it"
    }

    test("a topic with more samples than that defines the rows") {
        val view = timedView(timedTopic("Gain", 0.0 to 1.0), timedTopic("Gyro", *Array(11) { it * 0.001 to it.toDouble() }))
        val table = CsvTable.ofAll(view, Span(0.002, 0.004))
        linesOf(table) shouldContainExactly listOf("Time (s),Gain (V),Gyro (V)", "0.002,1,2", "0.003,1,3", "0.004,1,4")
        table.remark shouldBe ", one at each sample of “Gyro”, each with the last values before it"
    }

    test("a file with titles that are not ASCII is marked as UTF-8") {
        val view = timedView(timedTopic("Ärm", 0.0 to 1.0))
        CsvTable.ofAll(view).header shouldBe "\uFEFFTime (s),Ärm (V)\n"
    }
})
