package badlog.cli.merge

import badlog.cli.BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.core.recording.Recording
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div

class MergeSpec : FunSpec({
    fun Recording.numbers(name: String) = topics.first { it.name == name }.samples.map { if (it.isNaN()) null else it }

    fun bag(names: String, rows: String, unit: String = "s") = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"$unit\",\"attrs\":[\"xaxis\"]}," +
        names.split(",").joinToString { "{\"name\":\"$it\"}" } + "]}\nTime,$names\n" + rows.replace(" ", "\n") + "\n"

    test("a log that was cut in two, with an overlap, comes back as it was") {
        inFolder { folder ->
            badlog("cut", SAMPLES / "qualification-42.bag", "--to", "50", "-o", folder / "a.bag")
            badlog("cut", SAMPLES / "qualification-42.bag", "--from", "49", "-o", folder / "b.bag")
            val ended = badlogJson("merge", folder / "b.bag", folder / "a.bag", "-o", folder / "m.bag")
            ended.code shouldBe ExitCode.WHOLE
            val whole = readRecording(SAMPLES / "qualification-42.bag", LOG_FORMATS)
            val merged = readRecording(folder / "m.bag", LOG_FORMATS)
            merged.rowCount shouldBe whole.rowCount
            // As text, because NaN does not equal NaN.
            merged.topics.map { it.samples.joinToString() } shouldBe whole.topics.map { it.samples.joinToString() }
            merged.topics.map { it.kind } shouldBe whole.topics.map { it.kind }
            merged.topics.map { it.attributes } shouldBe whole.topics.map { it.attributes }
            merged.topics.map { topic -> List(topic.texts.size) { topic.texts[it] } } shouldBe
                whole.topics.map { topic -> List(topic.texts.size) { topic.texts[it] } }
            merged.values shouldBe whole.values
            ended.json.single().getValue("repeatedRows").jsonPrimitive.int shouldBe 50
            ended.json.single().getValue("overlaps").jsonArray.size shouldBe 1
        }
    }

    test("other topics are added, each at its own times, and topics with taken names go into a folder") {
        inFolder { folder ->
            val one = folder.with("one.bag", bag("a", "0,1 1,2 2,3"))
            val two = folder.with("two.bag", bag("a,b", "0.5,10,20 1,11,21 9,12,22"))
            val ended = badlog("merge", one, two, "-o", folder / "m.bag")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "renamed: “a” of"
            val merged = readRecording(folder / "m.bag", LOG_FORMATS)
            merged.topics.map { it.name } shouldContainExactly listOf("Time", "a", "two/a", "b")
            merged.numbers("Time") shouldContainExactly listOf(0.0, 0.5, 1.0, 2.0, 9.0)
            merged.numbers("a") shouldContainExactly listOf(1.0, null, 2.0, 3.0, null)
            merged.numbers("two/a") shouldContainExactly listOf(null, 10.0, 11.0, null, 12.0)
        }
    }

    test("rows that share x but differ are both kept") {
        inFolder { folder ->
            val one = folder.with("one.bag", bag("a", "0,1 1,2"))
            val two = folder.with("two.bag", bag("a", "1,3 2,4"))
            badlog("merge", one, two, "-o", folder / "m.bag").code shouldBe ExitCode.WHOLE
            readRecording(folder / "m.bag", LOG_FORMATS).numbers("a") shouldContainExactly listOf(1.0, 2.0, 3.0, 4.0)
        }
    }

    test("--append and --join decide otherwise than the topics") {
        inFolder { folder ->
            val one = folder.with("one.bag", bag("a", "0,1 1,2"))
            val two = folder.with("two.bag", bag("a,b", "5,3,7"))
            badlog("merge", one, two, "--append", "-o", folder / "m.bag")
            val appended = readRecording(folder / "m.bag", LOG_FORMATS)
            appended.topics.map { it.name } shouldContainExactly listOf("Time", "a", "b")
            appended.numbers("b") shouldContainExactly listOf(null, null, 7.0)
            val more = folder.with("more.bag", bag("a,b", "1,2,8"))
            badlog("merge", one, more, "--append", "-o", folder / "n.bag")
            readRecording(folder / "n.bag", LOG_FORMATS).numbers("b") shouldContainExactly listOf(null, null, 8.0)
            badlog("merge", one, one.parent.with("three.bag", bag("a", "0,9")), "--join", "-o", folder / "j.bag")
            readRecording(folder / "j.bag", LOG_FORMATS).numbers("three/a") shouldContainExactly listOf(9.0, null)
        }
    }

    test("logs without a common clock are refused, in one sentence") {
        inFolder { folder ->
            val one = folder.with("one.bag", bag("a", "0,1"))
            val millis = folder.with("ms.bag", bag("b", "0,1", unit = "ms"))
            badlog("merge", one, millis, "-o", folder / "m.bag").err shouldContain "not one clock"
            val csv = folder.with("c.csv", "Time,c\n0,1\n")
            val ended = badlog("merge", one, csv, "-o", folder / "m.bag")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "name the time topic with --x"
            badlog("merge", one, csv, "--x", "Time", "-o", folder / "m.bag").code shouldBe ExitCode.WHOLE
            badlog("merge", one, "-o", folder / "n.bag").err shouldContain "at least two logs"
        }
    }

    test("plain CSV files without x are merged in the order in which they were named") {
        inFolder { folder ->
            val one = folder.with("one.csv", "a,b\n1,x\n")
            val two = folder.with("two.csv", "b,a\ny,2\n")
            badlog("merge", two, one, "-o", folder / "m.csv").code shouldBe ExitCode.WHOLE
            readRecording(folder / "m.csv", LOG_FORMATS).numbers("a") shouldContainExactly listOf(2.0, 1.0)
        }
    }

    test("values that differ are kept by both names") {
        inFolder { folder ->
            val one = folder.with("one.bag", BAG)
            val two = folder.with("two.bag", BAG.replace("\"42\"", "\"43\""))
            badlog("merge", one, two, "-o", folder / "m.bag").code shouldBe ExitCode.WHOLE
            val merged = readRecording(folder / "m.bag", LOG_FORMATS)
            merged.values.map { "${it.name}=${it.text}" } shouldContainExactly listOf("Match Number=42", "two/Match Number=43")
            merged.rowCount shouldBe 5
        }
    }
})
