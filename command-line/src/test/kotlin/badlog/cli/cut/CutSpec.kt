package badlog.cli.cut

import badlog.cli.BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.sampleLog
import badlog.cli.with
import badlog.core.analysis.Span
import badlog.core.recording.Value
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import kotlinx.serialization.json.jsonArray
import kotlin.io.path.copyTo
import kotlin.io.path.div

class CutSpec : FunSpec({
    fun times(text: String, vararg options: String): List<Double> = inFolder { folder ->
        badlog("cut", folder.with("a.bag", text), *options, "-o", folder / "b.bag").code shouldBe ExitCode.WHOLE
        readRecording(folder / "b.bag", LOG_FORMATS).topics.first { it.name == "Time" }.samples.toList()
    }

    test("a range has both of its ends") {
        times(BAG, "--from", "0.02", "--to", "0.06") shouldContainExactly listOf(0.02, 0.04, 0.06)
        times(BAG, "--from=-1", "--to", "0:00.02") shouldContainExactly listOf(0.0, 0.02)
        times(BAG, "--from", "0:00.06") shouldContainExactly listOf(0.06, 0.08)
    }

    test("ends in the wrong order are named") {
        inFolder { folder ->
            badlog("cut", folder.with("a.bag", BAG), "--from", "0:00.06", "--to", "0.02", "-o", folder / "b.bag").err shouldContain
                "a.bag: --from 0:00.06 comes after --to 0.02; swap them."
        }
    }

    test("the enabled part, with a margin") {
        times(BAG, "--enabled", "--to", "0.06") shouldContainExactly listOf(0.02, 0.04, 0.06)
        times(BAG, "--enabled", "--margin", "0.025") shouldContainExactly listOf(0.0, 0.02, 0.04, 0.06, 0.08)
    }

    test("the time around each event is kept, regardless of case, and the time between two events is left out") {
        times(BAG, "--around", "GO", "--before", "0", "--after", "0.02") shouldContainExactly listOf(0.02, 0.04)
        inFolder { folder ->
            val ended = badlogJson("cut", folder.with("a.bag", BAG), "--around", "o", "--before", "0.001", "--after", "0")
            ended.json.single().getValue("parts").jsonArray.size shouldBe 2
            val cut = readRecording(folder / "a.cut.bag", LOG_FORMATS)
            cut.topics.first { it.name == "Log" }.texts.dictionary shouldContainExactly listOf("go", "stop")
            cut.values shouldBe readRecording(folder / "a.bag", LOG_FORMATS).values + Value("Part", "0.02 s to 0.02 s, 0.06 s to 0.06 s")
        }
    }

    test("a part names its range of the log, and a merge of parts does not") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            for (whole in listOf(SAMPLES / "practice.bag", log)) {
                fun values(vararg command: Any): List<Value> {
                    badlog(*command, "-o", folder / "out.wpilog", "--force").out shouldContain "out.wpilog"
                    return readRecording(folder / "out.wpilog", LOG_FORMATS).values
                }
                fun keep(name: String) = (folder / "out.wpilog").copyTo(folder / name, overwrite = true)
                values("cut", whole, "--to", "20").single { it.name == "Part" }.text shouldStartWith "0 s to "
                val one = keep("one.wpilog")
                values("cut", one, "--from", "5").single { it.name == "Part" }.text shouldStartWith "5"
                values("cut", whole, "--from", "20").map { it.name } shouldContain "Part"
                values("merge", one, keep("two.wpilog")).map { it.name } shouldNotContain "Part"
            }
        }
    }

    test("a state matches only at its beginning") {
        val state = "{\"topics\":[{\"name\":\"Time\",\"attrs\":[\"xaxis\"]},{\"name\":\"State\"}]}\nTime,State\n" +
            "0,IDLE\n1,RUN\n2,RUN\n3,RUN\n4,IDLE\n5,RUN\n"
        times(state, "--around", "run", "--before", "0", "--after", "0") shouldContainExactly listOf(1.0, 5.0)
    }

    test("a clock that is set keeps its rows in their order") {
        val set = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"y\"}]}\nTime,y\n" +
            "100,1\n101,2\n,3\n5,4\n6,5\n101,6\n"
        times(set, "--from", "101").map { if (it.isNaN()) "gap" else "$it" } shouldContainExactly listOf("101.0", "gap", "101.0")
    }

    test("an error names the missing data and the existing range") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("cut", log, "--from", "7").err shouldContain "there are no rows there; Time goes from 0 s to 0.08 s"
            badlog("cut", log, "--around", "nix").err shouldContain "no event and no state contains “nix”"
            val csv = folder.with("a.csv", "a,b\n1,2\n")
            badlog("cut", csv, "--enabled").err shouldContain "does not show when the robot was enabled"
            badlog("cut", csv, "--from", "1:00").err shouldContain "name the time topic with --x"
            badlog("cut", log, "--from", "7").code shouldBe ExitCode.NOTHING
        }
    }

    test("rows are selected as by looking at each span") {
        val x = Arb.double(0.0, 10.0, includeNaNs = false)
        checkAll(Arb.list(x, 0..50), Arb.list(Arb.pair(x, x).map { (a, b) -> Span(minOf(a, b), maxOf(a, b)) }, 0..6)) { positions, spans ->
            val rows = rowsIn(positions.toDoubleArray(), spans)
            for (row in positions.indices) rows[row] shouldBe spans.any { positions[row] in it }
            rows.runs().flatten() shouldBe positions.indices.filter { rows[it] }
        }
    }
})
