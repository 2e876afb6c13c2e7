package badlog.cli.merge

import badlog.cli.BAG
import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.core.recording.Recording
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.PropertyTesting
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.random.Random

class ClockChoiceSpec : FunSpec({
    fun Recording.times(name: String) = topics.first { it.name == name }.times?.toList()

    fun samples(begin: Double) = List(20) { begin + it / 2.0 to it.toDouble() }

    /** Enabled in the seconds 15 to 30 and 33 to 100 after [begin]. Times are of the robot's clock, which is [late] now and then. */
    fun enabled(begin: Double, late: Double = 0.0) = listOf(
        begin to false,
        begin + 15 to true,
        begin + 30 + late to false,
        begin + 33 to true,
        begin + 100 - late to false,
        begin + 110 to false,
    )

    fun Path.match(name: String, topic: String, begin: Double, late: Double = 0.0) = wpilog(
        "$name.wpilog",
        listOf(Logged("$name/Robot Enabled", "boolean", "", enabled(begin, late)), Logged(topic, "int64", "", samples(begin))),
    )

    fun moved(json: JsonObject) = json.getValue("moved").jsonArray.single().jsonObject

    test("logs that are minutes apart are reported, and moved by a given offset") {
        inFolder { folder ->
            val one = folder.match("one", "a", 0.0)
            val two = folder.match("two", "b", 1200.0)
            val ended = badlog("merge", one, two, "-o", folder / "m.wpilog")
            ended.out.replace(Regex("\\s+"), " ") shouldContain "one.wpilog ends 18:10.0 before"
            ended.out shouldContain "--align"
            val json = badlogJson("merge", one, two, "-o", folder / "n.wpilog").json.single()
            json.getValue("apart").jsonArray.single().jsonObject.getValue("seconds").jsonPrimitive.double shouldBe 1090.0
            val given = badlog("merge", one, two, "--offset", "two.wpilog=-1199.5", "-o", folder / "o.wpilog")
            given.out shouldNotContain "apart"
            given.out shouldContain "two.wpilog by -1199.5 s"
            readRecording(folder / "o.wpilog", LOG_FORMATS).times("b") shouldBe List(20) { 0.5 + it / 2.0 }
        }
    }

    test("logs are aligned by when the robot was enabled, and the error is reported") {
        inFolder { folder ->
            val one = folder.match("one", "a", 7.0)
            val two = folder.match("two", "b", 1200.0, late = 0.02)
            val json = badlogJson("merge", one, two, "--align", "enabled", "-o", folder / "m.wpilog").json.single()
            moved(json).getValue("edges").jsonPrimitive.int shouldBe 4
            moved(json).getValue("seconds").jsonPrimitive.double shouldBe (-1193.0 plusOrMinus 0.011)
            moved(json).getValue("error").jsonPrimitive.double shouldBe (0.02 plusOrMinus 0.01)
            json.getValue("apart").jsonArray.size shouldBe 0
            val times = checkNotNull(readRecording(folder / "m.wpilog", LOG_FORMATS).times("b"))
            times[0] shouldBe (7.0 plusOrMinus 0.011)
            badlog("merge", one, two, "--align", "enabled", "-o", folder / "n.wpilog").out.replace(Regex("\\s+"), " ") shouldContain
                "4 edges of enabled fit within 0.02 s"
        }
    }

    test("the order of the logs makes no difference to the times, and no log is refused because of it") {
        inFolder { folder ->
            val random = Random(4042)
            repeat(10) { run ->
                // Each log has the same moments of enabling on its own clock.
                val logs = ('a'..'c').take(random.nextInt(2, 4)).map { folder.match("$it$run", "$it", random.nextInt(0, 4000) / 2.0) }
                val merged = List(3) { logs.shuffled(random) }.mapIndexed { index, order ->
                    val target = folder / "m$run-$index.wpilog"
                    badlog("merge", *order.toTypedArray(), "--align", "enabled", "-o", target).code shouldBe ExitCode.WHOLE
                    readRecording(target, LOG_FORMATS).topics.associate { it.name to it.times?.toList() }
                }
                merged.toSet().size shouldBe 1
                val first = merged[0].values.map { it?.first() ?: 0.0 }
                (first.min() >= 0) shouldBe true
            }
        }
    }

    test("a log that fits only another one than the first has its place beside that one") {
        inFolder { folder ->
            fun cut(name: String, topic: String, from: Int, until: Int, late: Double): Path {
                val changes = List(12) { (10.0 + it * it * 3 + it) to (it % 2 == 0) }
                val kept = listOf(changes[from].first - 5 to (from % 2 == 1)) + changes.subList(from, until) +
                    listOf(changes[until - 1].first + 5 to ((until - 1) % 2 == 0))
                val moved = kept.map { (time, on) -> time + late to on }
                val others = List(5) { changes[from].first + it + late to it.toDouble() }
                return folder.wpilog(name, listOf(Logged("$topic/Robot Enabled", "boolean", "", moved), Logged(topic, "int64", "", others)))
            }
            // The first and the last share no moment, and the one in the middle shares some with both.
            val first = cut("a.wpilog", "a", 0, 5, 0.0)
            val last = cut("b.wpilog", "b", 6, 12, 700.0)
            val middle = cut("c.wpilog", "c", 2, 10, 90.0)
            val json = badlogJson("merge", first, last, middle, "--align", "enabled", "-o", folder / "m.wpilog").json.single()
            json.getValue("moved").jsonArray.size shouldBe 2
            val merged = readRecording(folder / "m.wpilog", LOG_FORMATS)
            val begins = listOf("a", "b", "c").map { checkNotNull(merged.times(it)).first() }
            (begins[1] - begins[0]) shouldBe (10.0 + 36 * 3 + 6 - 10 plusOrMinus 0.001)
            (begins[2] - begins[0]) shouldBe (10.0 + 12 + 2 - 10 plusOrMinus 0.001)
        }
    }

    test("whatever is merged, in whatever way, the order of the logs changes no byte of the result, and no word about it") {
        inFolder { folder ->
            val random = Random(1959)
            repeat(PropertyTesting.defaultIterationCount / 20) { run ->
                val here = (folder / "run$run").createDirectories()
                val begins = List(3) { random.nextInt(0, 400) / 2.0 }
                val logs = begins.mapIndexed { i, begin -> here.match("log${random.nextInt(20)}-$i", listOf("a", "b", "a")[i], begin) } +
                    listOf(here.with("rows.bag", BAG), here.with("more.bag", BAG.replace("Speed", "Force").replace("\"42\"", "\"43\"")))
                val chosen = logs.shuffled(random).take(random.nextInt(2, 6))
                val aligned = chosen.filter { "${it.fileName}".startsWith("log") }
                val ways = listOf(emptyList(), listOf("--join"), listOf("--append"), listOf("--offset", "${chosen[0].fileName}=12.5")) +
                    (if (aligned.size > 1) listOf(listOf("--align", "enabled")) else emptyList())
                for ((index, way) in ways.withIndex()) {
                    val taken = if ("--align" in way) aligned else chosen
                    val made = List(3) { taken.shuffled(random) }.map { order ->
                        val target = here / "merged$index.wpilog"
                        val ended = badlog("merge", *order.toTypedArray(), *way.toTypedArray(), "-o", target, "--force")
                        Triple(ended.code, ended.out + ended.err, if (target.exists()) target.readBytes().toList() else emptyList())
                    }
                    withClue("$way of $taken") { made.toSet().size shouldBe 1 }
                }
            }
        }
    }

    test("a log that would begin before 0 moves the others instead") {
        inFolder { folder ->
            val late = folder.match("late", "a", 3.0)
            val early = folder.wpilog("early.wpilog", listOf(Logged("early/Robot Enabled", "boolean", "", enabled(20.0)), Logged("b", "int64", "", samples(0.0))))
            val times = listOf(listOf(late, early), listOf(early, late)).mapIndexed { index, order ->
                val ended = badlog("merge", *order.toTypedArray(), "--align", "enabled", "-o", folder / "m$index.wpilog")
                ended.code shouldBe ExitCode.WHOLE
                readRecording(folder / "m$index.wpilog", LOG_FORMATS).run { topics.associate { it.name to it.times?.toList() } }
            }
            times[0] shouldBe times[1]
            times[0].getValue("b")?.first() shouldBe 0.0
        }
    }

    test("the log of a robot comes before the log of a CAN bus, whatever their names") {
        inFolder { folder ->
            val recording = readRecording(folder.match("robot", "a", 7.0), LOG_FORMATS)
            listOf("aaa.hoot", "robot.wpilog").map { LogPart(folder / it, recording) }.sortedWith(PART_ORDER).map { "${it.file.fileName}" } shouldBe
                listOf("robot.wpilog", "aaa.hoot")
        }
    }

    test("a log with an offset keeps that, and the others are aligned with it") {
        inFolder { folder ->
            val one = folder.match("one", "a", 7.0)
            val two = folder.match("two", "b", 1200.0)
            for (order in listOf(listOf(one, two), listOf(two, one))) {
                for ((offset, begin) in listOf("one.wpilog=3" to 10.0, "two.wpilog=-1100" to 100.0)) {
                    val target = folder / "m.wpilog"
                    badlog("merge", *order.toTypedArray(), "--align", "enabled", "--offset", offset, "-o", target, "--force").code shouldBe ExitCode.WHOLE
                    val merged = readRecording(target, LOG_FORMATS)
                    listOf("a", "b").map { merged.times(it)?.first() } shouldBe listOf(begin, begin)
                }
            }
        }
    }

    test("rows are moved in the unit of their x, and keep their digits") {
        inFolder { folder ->
            fun bag(name: String, unit: String, rows: String) = folder.with(
                "$name.bag",
                "{\"topics\":[{\"name\":\"Time\",\"unit\":\"$unit\",\"attrs\":[\"xaxis\"]},{\"name\":\"$name\"}]}\nTime,$name\n$rows",
            )
            val one = bag("a", "ms", "0,1\n20,2\n")
            val two = bag("b", "ms", "100.1,1\n120.1,2\n")
            badlog("merge", one, two, "--offset", "b.bag=-0.1", "-o", folder / "m.bag").code shouldBe ExitCode.WHOLE
            val merged = readRecording(folder / "m.bag", LOG_FORMATS)
            merged.topics.first { it.name == "Time" }.samples.toList() shouldContainExactly listOf(0.0, 0.1, 20.0, 20.1)
        }
    }

    test("a log that cannot be moved or aligned is refused with the reason and the next step") {
        inFolder { folder ->
            val one = folder.match("one", "a", 0.0)
            val two = folder.wpilog("two.wpilog", listOf(Logged("b", "int64", "", samples(5.0))))
            badlog("merge", one, two, "--align", "enabled", "-o", folder / "m.wpilog").err shouldContain
                "two.wpilog does not show when the robot was enabled or disabled; use --offset"
            badlog("merge", one, two, "--offset", "two.wpilog=-5.5", "-o", folder / "m.wpilog").err shouldContain "would start before 0"
            badlog("merge", one, two, "--offset", "nix.wpilog=1", "-o", folder / "m.wpilog").code shouldBe ExitCode.USAGE
            badlog("merge", one, two, "--offset", "two.wpilog=soon", "-o", folder / "m.wpilog").err shouldContain "FILE=SECONDS"
            badlog("merge", one, two, "--align", "disabled", "-o", folder / "m.wpilog").code shouldBe ExitCode.USAGE
            val rows = folder.with("c.csv", "c,d\n1,2\n")
            badlog("merge", one, rows, "--offset", "c.csv=1", "-o", folder / "m.wpilog").err shouldContain "name the topic of time with --x"
        }
    }
})
