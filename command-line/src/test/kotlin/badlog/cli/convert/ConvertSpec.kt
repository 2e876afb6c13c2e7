package badlog.cli.convert

import badlog.cli.BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.with
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText

class ConvertSpec : FunSpec({
    test("every sample keeps all of its numbers and texts in either format") {
        inFolder { folder ->
            for (log in listOf("practice.bag", "qualification-57.bag.gz", "elevator-bench.csv")) {
                for (name in listOf("to.csv", "to.bag", "to.bag.gz")) {
                    badlog("convert", SAMPLES / log, "-o", folder / name, "--force")
                    val before = readRecording(SAMPLES / log, LOG_FORMATS)
                    val after = readRecording(folder / name, LOG_FORMATS)
                    after.topics.map { it.name } shouldBe before.topics.map { it.name }
                    // As text, because NaN does not equal NaN.
                    after.topics.map { it.samples.joinToString() } shouldBe before.topics.map { it.samples.joinToString() }
                    after.topics.map { it.texts.dictionary } shouldBe before.topics.map { it.texts.dictionary }
                }
            }
        }
    }

    test("content that CSV cannot hold is listed") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("convert", log, "--to", "csv").out shouldContain "5 rows; the file cannot hold 2 units, 2 attributes, 1 value"
            (folder / "a.csv").readText().lines().first() shouldBe "Time,Speed,Enabled,Log"
            val json = badlogJson("convert", log, "--to", "csv", "--force").json.single()
            json.getValue("leftOut").jsonArray.map { it.jsonPrimitive.content } shouldContainExactly
                listOf("2 units", "2 attributes", "1 value")
        }
    }

    test("rounded whole numbers of a CSV file are listed") {
        inFolder { folder ->
            val log = folder.with("a.csv", "Time;ID\n" + (0 until 5).joinToString("") { "0,0$it;${9007199254740993L + 2 * it}\n" })
            val json = badlogJson("convert", log, "--to", "bag").json.single()
            json.getValue("leftOut").jsonArray.map { it.jsonPrimitive.content } shouldContainExactly
                listOf("“ID”: Whole numbers beyond 2^53 are rounded (5).")
            (folder / "a.bag").readText().lines()[2] shouldBe "0,9007199254740992"
        }
    }

    test("the name after --out shows the format, and whether to compress") {
        inFolder { folder ->
            badlog("convert", folder.with("a.bag", BAG), "-o", folder / "b.csv.gz").code shouldBe ExitCode.WHOLE
            (folder / "b.csv.gz").readBytes()[0] shouldBe 0x1f
            badlog("convert", "--gzip", "--to", "csv", folder / "a.bag")
            folder.names() shouldContainExactly listOf("a.bag", "a.csv.gz", "b.csv.gz")
        }
    }

    test("two logs with the same result name get two results") {
        inFolder { folder ->
            folder.with("in/a.bag", BAG)
            folder.with("in/a.badbag", BAG)
            badlog("convert", folder / "in", "--to", "csv", "-o", folder / "out").code shouldBe ExitCode.WHOLE
            (folder / "out").names() shouldContainExactly listOf("a (2).csv", "a.csv")
        }
    }

    test("CSV becomes a bag with an x axis") {
        inFolder { folder ->
            badlog("convert", SAMPLES / "elevator-bench.csv", "--x", "Time", "-o", folder / "a.bag").code shouldBe ExitCode.WHOLE
            readRecording(folder / "a.bag", LOG_FORMATS).topics[0].attributes shouldContainExactly listOf("xaxis")
        }
    }

    test("topics that are calculated become columns, or entries") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("convert", log, "--to", "csv", "--topic", "Twice [m/s] = Speed * 2", "--topic", "Odd = Sped")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "“Sped” is not a topic"
            val lines = (folder / "a.csv").readText().lines()
            lines[0] shouldBe "Time,Speed,Enabled,Log,Twice"
            lines.drop(1).take(4).map { it.substringAfterLast(',') } shouldBe listOf("3", "5", "7", "")
            badlog("convert", log, "--to", "bag", "--out", folder / "b.bag", "--topic", "Twice [m/s] = Speed * 2").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "b.bag").out shouldContain Regex("Twice +m/s +numeric +4 ")
            badlog("convert", folder / "b.bag", "--to", "wpilog", "--topic", "Fast = Twice > 6").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "b.wpilog").out shouldContain Regex("Fast +boolean ")
            badlog("convert", folder / "b.wpilog", "--out", folder / "c.wpilog", "--topic", "Slow = not Fast").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "c.wpilog").out shouldContain Regex("Slow +boolean ")
        }
    }

    test("a calculated topic without a value in each row is left out of rows, and reported") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG.replace("0.02,2.5", ",2.5"))
            badlog("convert", log, "--to", "csv", "--topic", "Twice = Speed * 2").out shouldContain "1 calculated topic"
            (folder / "a.csv").readText().lines()[0] shouldBe "Time,Speed,Enabled,Log"
        }
    }

    test("--only writes the topics with matching names, and the x axis") {
        inFolder { folder ->
            badlog("convert", folder.with("a.bag", BAG), "--to", "csv", "--only", "sp*").code shouldBe ExitCode.WHOLE
            (folder / "a.csv").readText().lines().take(2) shouldBe listOf("Time,Speed", "0,1.5")
        }
    }

    test("a log without any topic that --only names is reported, and nothing is written") {
        inFolder { folder ->
            val ended = badlog("convert", folder.with("a.bag", BAG), "--to", "csv", "--only", "Arm/*")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "no topic that matches “Arm/*”"
            (folder / "a.csv").exists() shouldBe false
        }
    }
})
