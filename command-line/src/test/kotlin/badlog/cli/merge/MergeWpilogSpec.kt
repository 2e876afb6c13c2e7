package badlog.cli.merge

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.sampleLog
import badlog.cli.with
import badlog.cli.wpilog
import badlog.core.recording.Recording
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div

/** What [name] holds: its times, with its number or text at each. */
private fun Recording.held(name: String): List<String> {
    val topic = topics.single { it.name == name }
    val texts = List(topic.texts.size) { topic.texts.rows[it] to topic.texts[it] }.toMap()
    return checkNotNull(topic.times).mapIndexed { i, time -> "$time ${texts[i] ?: topic.samples[i]}" }
}

private fun numbers(name: String, vararg samples: Pair<Double, Double>) = Logged(name, "double", "{\"unit\":\"V\"}", samples.toList())

class MergeWpilogSpec : FunSpec({
    test("pieces with the same topics follow each other in time, and common records are included once") {
        inFolder { folder ->
            fun texts(vararg samples: Pair<Double, String>) = Logged("s", "string", "", samples.toList())
            val one = folder.wpilog("one.wpilog", listOf(numbers("a", 0.0 to 1.0, 1.0 to 2.0, 2.0 to 3.0), texts(0.5 to "x")))
            val other = listOf(numbers("a", 1.0 to 2.0, 2.0 to 9.0, 3.0 to 4.0), texts(0.5 to "x", 4.0 to "y"))
            val two = folder.wpilog("two.wpilog", other)
            val ended = badlogJson("merge", two, one, "-o", folder / "m.wpilog")
            ended.code shouldBe ExitCode.WHOLE
            val merged = readRecording(folder / "m.wpilog", LOG_FORMATS)
            merged.held("a") shouldContainExactly listOf("0.0 1.0", "1.0 2.0", "2.0 3.0", "2.0 9.0", "3.0 4.0")
            merged.held("s") shouldContainExactly listOf("0.5 x", "4.0 y")
            merged.topics.map { it.type } shouldContainExactly listOf("double", "string")
            merged.topics[0].unit shouldBe "V"
            ended.json.single().getValue("repeatedSamples").jsonPrimitive.int shouldBe 2
            ended.json.single().getValue("overlaps").jsonArray.size shouldBe 1
        }
    }

    test("a log that was cut in two comes back, with one more value where the second begins") {
        inFolder { folder ->
            val whole = folder.sampleLog("practice.bag")
            badlog("cut", whole, "--to", "20", "-o", folder / "a.wpilog").code shouldBe ExitCode.WHOLE
            badlog("cut", whole, "--from", "19.01", "-o", folder / "b.wpilog").code shouldBe ExitCode.WHOLE
            badlog("merge", folder / "b.wpilog", folder / "a.wpilog", "-o", folder / "m.wpilog").code shouldBe ExitCode.WHOLE
            val before = readRecording(whole, LOG_FORMATS)
            val after = readRecording(folder / "m.wpilog", LOG_FORMATS)
            after.values shouldBe before.values
            for ((one, other) in before.topics.zip(after.topics)) {
                other.name shouldBe one.name
                other.metadata shouldBe one.metadata
                other.type shouldBe one.type
                val times = checkNotNull(one.times).toSet()
                val kept = checkNotNull(other.times).indices.filter { other.times!![it] in times }
                if (one.samples.isNotEmpty()) kept.map { other.samples[it] } shouldBe one.samples.toList()
                (other.size - kept.size <= 1) shouldBe true
            }
        }
    }

    test("logs with other topics are joined side by side, and taken names go into a folder") {
        inFolder { folder ->
            val one = folder.wpilog("one.wpilog", listOf(numbers("a", 0.0 to 1.0)))
            val two = folder.wpilog("two.wpilog", listOf(numbers("a", 0.0 to 5.0), numbers("b", 0.5 to 6.0)))
            badlog("merge", one, two, "-o", folder / "m.wpilog").out shouldContain "joined: "
            readRecording(folder / "m.wpilog", LOG_FORMATS).topics.map { it.name } shouldContainExactly listOf("a", "two/a", "b")
            badlog("merge", one, two, "--append", "-o", folder / "n.wpilog")
            readRecording(folder / "n.wpilog", LOG_FORMATS).held("a") shouldContainExactly listOf("0.0 1.0", "0.0 5.0")
        }
    }

    test("numbers and texts with the same name stay two topics") {
        inFolder { folder ->
            val one = folder.wpilog("one.wpilog", listOf(numbers("a", 0.0 to 1.0)))
            val two = folder.wpilog("two.wpilog", listOf(Logged("a", "string", "", listOf(1.0 to "text"))))
            badlog("merge", one, two, "-o", folder / "m.wpilog")
            val merged = readRecording(folder / "m.wpilog", LOG_FORMATS)
            merged.held("a") shouldContainExactly listOf("0.0 1.0")
            merged.held("two/a") shouldContainExactly listOf("1.0 text")
        }
    }

    test("a bag beside a WPILOG keeps its times, and the gaps of topics that are not sparse") {
        inFolder { folder ->
            val bag = folder.with(
                "b.bag",
                "{\"topics\":[{\"name\":\"T\",\"unit\":\"ms\",\"attrs\":[\"xaxis\"]}]}\nT,y,rare,e\n" +
                    "0,1,1,\n500,,,\n700,2,,boom\n600,3,,\n,4,2,\n900,5,,\n",
            )
            val log = folder.wpilog("a.wpilog", listOf(numbers("a", 0.25 to 1.0)))
            badlog("merge", log, bag, "-o", folder / "m.wpilog").code shouldBe ExitCode.WHOLE
            val merged = readRecording(folder / "m.wpilog", LOG_FORMATS)
            merged.topics.map { it.name } shouldContainExactly listOf("a", "y", "rare", "e")
            merged.held("y") shouldContainExactly listOf("0.0 1.0", "0.5 NaN", "0.6 3.0", "0.6 4.0", "0.7 2.0", "0.9 5.0")
            merged.held("rare") shouldContainExactly listOf("0.0 1.0", "0.6 2.0")
            merged.held("e") shouldContainExactly listOf("0.7 boom")
            merged.topics.last().attributes shouldContainExactly listOf("log")
        }
    }

    test("bags that become a WPILOG keep their times, so that no gaps come between them") {
        inFolder { folder ->
            fun bag(name: String, offset: Double) = folder.with(
                "$name.bag",
                "{\"topics\":[{\"name\":\"T\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"$name\"}]}\nT,$name\n" +
                    (0 until 50).joinToString("") { "${it / 50.0 + offset},$it\n" },
            )
            badlog("merge", bag("a", 0.0), bag("b", 0.01), "-o", folder / "m.wpilog").code shouldBe ExitCode.WHOLE
            val merged = readRecording(folder / "m.wpilog", LOG_FORMATS)
            merged.topics.map { topic -> topic.samples.toList() } shouldContainExactly List(2) { List(50) { it.toDouble() } }
        }
    }

    test("logs without a common clock, or without rows for a bag, are refused in one sentence") {
        inFolder { folder ->
            val log = folder.wpilog("a.wpilog", listOf(numbers("a", 0.25 to 1.0)))
            val csv = folder.with("c.csv", "Time,c\n0,1\n")
            badlog("merge", log, csv, "-o", folder / "m.wpilog").err shouldContain "name the time topic with --x"
            badlog("merge", log, csv, "--x", "Time", "-o", folder / "m.wpilog").code shouldBe ExitCode.WHOLE
            val meters = folder.with("d.bag", "{\"topics\":[{\"name\":\"x\",\"unit\":\"m\",\"attrs\":[\"xaxis\"]}]}\nx,y\n0,1\n")
            badlog("merge", log, meters, "-o", folder / "n.wpilog").err shouldContain "not one clock"
            val ended = badlog("merge", log, csv, "--x", "Time", "-o", folder / "m.bag")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "use a name that ends in .wpilog"
        }
    }

    test("one name with two types is two topics, and the result names both") {
        inFolder { folder ->
            val one = folder.wpilog("one.wpilog", listOf(numbers("a", 0.0 to 1.0)))
            val two = folder.wpilog("two.wpilog", listOf(Logged("a", "int64", "", listOf(1.0 to 2.0))))
            val ended = badlog("merge", one, two, "-o", folder / "m.wpilog")
            ended.out.replace(Regex("\\s+"), " ") shouldContain "is “two/a”; its type is int64, and double in $one"
            readRecording(folder / "m.wpilog", LOG_FORMATS).topics.map { it.name to it.type } shouldContainExactly
                listOf("a" to "double", "two/a" to "int64")
        }
    }

    test("many new names are counted, and all of them are in JSON") {
        inFolder { folder ->
            val one = folder.wpilog("one.wpilog", List(20) { numbers("t$it", 0.0 to 1.0) })
            val two = folder.wpilog("two.wpilog", List(20) { numbers("t$it", 0.0 to 2.0) } + numbers("more", 1.0 to 1.0))
            val ended = badlog("merge", one, two, "-o", folder / "m.wpilog")
            ended.out shouldContain "renamed: 10 more in the same way"
            ended.out shouldNotContain "t19"
            badlogJson("merge", one, two, "-o", folder / "n.wpilog").json.single().getValue("renamed").jsonArray.size shouldBe 20
        }
    }

    test("appended samples are sorted, and common ones included once") {
        val samples = Arb.list(Arb.pair(Arb.int(0, 9), Arb.int(0, 3)), 0..12)
        inFolder { folder ->
            checkAll(60, samples, samples) { one, other ->
                fun log(name: String, list: List<Pair<Int, Int>>) = folder.wpilog(
                    name,
                    listOf(numbers("a", *list.distinct().sortedBy { it.first }.map { (t, v) -> t * 1.0 to v * 1.0 }.toTypedArray())),
                )
                badlog("merge", log("1.wpilog", one), log("2.wpilog", other), "-o", folder / "m.wpilog", "--force")
                val merged = readRecording(folder / "m.wpilog", LOG_FORMATS).topics.single()
                val pairs = checkNotNull(merged.times).indices.map { merged.times!![it].toInt() to merged.samples[it].toInt() }
                pairs.map { it.first } shouldBe pairs.map { it.first }.sorted()
                pairs.toSet() shouldBe (one + other).toSet()
            }
        }
    }
})
