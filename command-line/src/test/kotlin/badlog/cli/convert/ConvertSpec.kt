package badlog.cli.convert

import badlog.cli.BAG
import badlog.cli.ExitCode
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.inFolder
import badlog.cli.names
import badlog.cli.with
import badlog.file.readRecording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive

class ConvertSpec : FunSpec({
    test("every sample keeps all of its numbers and texts in either format") {
        inFolder { folder ->
            for (log in listOf("practice.bag", "qualification-57.bag.gz", "elevator-bench.csv")) {
                for (name in listOf("to.csv", "to.bag", "to.bag.gz")) {
                    badlog("convert", SAMPLES / log, "-o", folder / name, "--force")
                    val before = readRecording(SAMPLES / log)
                    val after = readRecording(folder / name)
                    after.topics.map { it.name } shouldBe before.topics.map { it.name }
                    // As text, because NaN does not equal NaN.
                    after.topics.map { it.samples.joinToString() } shouldBe before.topics.map { it.samples.joinToString() }
                    after.topics.map { it.texts.dictionary } shouldBe before.topics.map { it.texts.dictionary }
                }
            }
        }
    }

    test("what CSV has no place for is listed") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("convert", log, "--to", "csv").out shouldContain "5 rows; without 2 units, 2 attributes, 1 value"
            (folder / "a.csv").readText().lines().first() shouldBe "Time,Speed,Enabled,Log"
            val json = badlogJson("convert", log, "--to", "csv", "--force").json.single()
            json.getValue("leftOut").jsonArray.map { it.jsonPrimitive.content } shouldContainExactly
                listOf("2 units", "2 attributes", "1 value")
        }
    }

    test("the name after --out tells the format, and whether to compress") {
        inFolder { folder ->
            badlog("convert", folder.with("a.bag", BAG), "-o", folder / "b.csv.gz").code shouldBe ExitCode.WHOLE
            (folder / "b.csv.gz").readBytes()[0] shouldBe 0x1f
            badlog("convert", "--gzip", "--to", "csv", folder / "a.bag")
            folder.names() shouldContainExactly listOf("a.bag", "a.csv.gz", "b.csv.gz")
        }
    }

    test("two logs that would have one result have two") {
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
            readRecording(folder / "a.bag").topics[0].attributes shouldContainExactly listOf("xaxis")
        }
    }
})
