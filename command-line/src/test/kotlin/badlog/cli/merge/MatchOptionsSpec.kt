package badlog.cli.merge

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.PropertyTesting
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.random.Random

/** Options that say how the clocks of logs fit, and which Driver Station log belongs to them. */
class MatchOptionsSpec : FunSpec({
    test("--align, --offset and --with-ds give info and export what merge writes, in any order of the logs") {
        inFolder { folder ->
            val random = Random(12)
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val logs = listOf(folder.robot("arm.wpilog", "Arm", -10.0), folder.robot("eye.wpilog", "Eye", 2.0), folder.robot("leg.wpilog", "Leg", -1.0))
            val ways = listOf(
                logs to listOf("--align", "enabled"),
                logs to listOf("--offset", "eye.wpilog=3.5"),
                logs to listOf("--align", "enabled", "--with-ds=$stations"),
                logs.take(1) to listOf("--with-ds=$stations"),
            )
            repeat(maxOf(1, PropertyTesting.defaultIterationCount / 100)) { run ->
                for ((index, way) in ways.withIndex()) {
                    val (given, options) = way
                    val merged = folder / "merged$run-$index.wpilog"
                    badlog("merge", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "-o", merged).code shouldBe ExitCode.WHOLE
                    val expected = badlogJson("info", merged).json.single()
                    val info = badlogJson("info", *given.shuffled(random).toTypedArray(), *options.toTypedArray()).json.single()
                    withClue("$options") {
                        for (key in listOf("topics", "values", "x", "samples")) info[key] shouldBe expected[key]
                    }
                    val page = folder / "page$run-$index.html"
                    badlog("export", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "-o", page).code shouldBe ExitCode.WHOLE
                    page.readText().length shouldBeGreaterThan 1000
                    // What rules find, and where, is the same in what merge writes. With --with-ds alone, they use the robot's log as it is.
                    fun reported(vararg arguments: Any) = badlogJson("report", *arguments, "--no-cache").json.single().filterKeys { it != "file" && it != "driverStation" }
                    if (options.size > 1 || "--with-ds" !in options[0]) {
                        withClue("$options") { reported(*given.shuffled(random).toTypedArray(), *options.toTypedArray()) shouldBe reported(merged) }
                    }
                    val pages = folder / "report$run-$index"
                    badlog("report", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "--out", pages).code shouldBe ExitCode.WHOLE
                    pages.listDirectoryEntries("*.html").size shouldBe 2
                }
            }
        }
    }

    test("a Driver Station's log that is given and found is there once; a place that is given counts") {
        inFolder { folder ->
            folder.robot("robot.wpilog", "Arm", 2.0)
            folder.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val alone = badlogJson("merge", folder / "robot.wpilog", "--with-ds", "-o", folder / "alone.out").json.single()
            val both = badlogJson("merge", folder, "--with-ds", "-o", folder / "both.out").json.single()
            both["samples"] shouldBe alone["samples"]
            both["moved"] shouldBe alone["moved"]
            val given = badlogJson("merge", folder, "--with-ds", "--offset", "2026_03_07 10_04_05 Sat.dslog=1.5", "-o", folder / "given.out").json.single()
            given.getValue("moved").jsonArray.map { it.jsonObject.getValue("seconds").jsonPrimitive.double } shouldBe listOf(1.5)
            badlog("merge", folder, "--with-ds", "-o", folder / "m.zip").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "m.zip").code shouldBe ExitCode.WHOLE
        }
    }

    test("logs without an x axis are appended in the order given, not by name") {
        inFolder { folder ->
            val logs = listOf(folder.with("b.csv", "Motor,Amps\n1,2\n"), folder.with("a.csv", "Motor,Amps\n3,4\n"), folder.with("c.csv", "Motor,Amps\n5,6\n"))
            for (order in listOf(logs, logs.reversed())) {
                val merged = folder / "all.csv"
                badlog("merge", *order.toTypedArray(), "-o", merged, "--force").oneLine() shouldContain "in the order given: ${order[0]}"
                merged.readText() shouldBe "Motor,Amps\n" + order.joinToString("") { it.readText().substringAfter('\n') }
            }
        }
    }

    test("a log that cannot be read is reported, and the others are read without it") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0)
            val broken = folder.with("broken.wpilog", "%PDF-1.4")
            for (command in listOf(listOf("info"), listOf("report", "--no-cache"), listOf("export", "-o", folder / "p.html", "--force"))) {
                val ended = badlog(command[0], log, broken, folder.robot("eye.wpilog", "Eye", 0.0), "--align", "enabled", *command.drop(1).toTypedArray())
                ended.code shouldBe ExitCode.SALVAGED
                ended.oneLine() shouldContain "broken.wpilog"
            }
        }
    }

    test("info with --with-ds searches beside the robot's log, says how its clock was found, and accepts no log just because it is the only one") {
        inFolder { folder ->
            val stations = (folder / "robot").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val cameras = (folder / "camera").createDirectory()
            val camera = cameras.wpilog("aaa.wpilog", listOf(Logged("/Camera/Angle", "double", "", List(5) { it * 1.0 to 1.0 })))
            val robot = stations.robot("robot.wpilog", "Arm", 0.0)
            badlog("merge", camera, robot, "--with-ds", "-o", folder / "m.wpilog").oneLine() shouldContain "4 edges of enabled fit"
            badlog("info", camera, robot, "--offset", "aaa.wpilog=1", "--with-ds").oneLine() shouldContain "aaa.wpilog by 1 s"

            val other = (folder / "other").createDirectory()
            other.with("2026_03_07 10_04_05 Sat.dslog", TestDslog(start = STATION_START).records(100).records(30, Status.BOTH_AUTO).records(100).bytes)
            for (command in listOf("info", "report")) {
                val ended = badlog(command, robot, "--with-ds=$other", "--json").json.single()
                "$ended" shouldNotContain "Driver Station/Battery Voltage"
                "$ended" shouldNotContain "driverStation"
            }
            val sentence = "robot.wpilog: no Driver Station log of its match was found, so it is shown as it is."
            badlog("info", robot, "--with-ds=$other").oneLine() shouldContain sentence
            badlog("export", robot, "--with-ds=$other", "-o", folder / "p.html").oneLine() shouldContain sentence
            badlog("info", robot, "--with-ds").oneLine() shouldNotContain "no Driver Station log"
        }
    }

    test("samples of the Driver Station's log before the robot's 0 are said to be left out, also in JSON") {
        inFolder { folder ->
            val robot = folder.robot("arm.wpilog", "Arm", 2.0)
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            for (command in listOf(listOf("info"), listOf("export", "-o", folder / "p.html", "--force"))) {
                for (json in listOf(emptyList(), listOf("--json"))) {
                    val ended = badlog(command[0], robot, "--with-ds=$stations", *command.drop(1).toTypedArray(), *json.toTypedArray())
                    withClue("$command $json") { ended.err.replace(Regex("\\s+"), " ") shouldContain Regex("without [\\d,]+ samples before 0") }
                }
            }
        }
    }

    test("a merge reports doubt and damage, also in JSON: a single matching edge, and data lost in the Driver Station's log") {
        inFolder { folder ->
            fun enabled(name: String, late: Double) = folder.wpilog(name, listOf(Logged("$name/Robot Enabled", "boolean", "", listOf(late to false, late + 4 to true, late + 5 to true)), Logged("$name/a", "double", "", listOf(late to 1.0))))
            val (one, two) = enabled("one.wpilog", 0.0) to enabled("two.wpilog", 7.0)
            for (json in listOf(emptyList(), listOf("--json"))) {
                val ended = badlog("info", one, two, "--align", "enabled", *json.toTypedArray())
                ended.err.replace(Regex("\\s+"), " ") shouldContain "one edge of enabled fits, which may be chance"
            }
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes.let { it.copyOf(it.size - 3) })
            badlog("info", folder.robot("arm.wpilog", "Arm", 0.0), "--with-ds=$stations", "--problems").run {
                code shouldBe ExitCode.SALVAGED
                oneLine() shouldContain "record"
            }
        }
    }

    test("a Driver Station's log beside the logs of two robots of one match is offered to both, and taken by none") {
        inFolder { folder ->
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val (one, two) = folder.robot("one.wpilog", "Arm", 0.0) to folder.robot("two.wpilog", "Arm", -2.0)
            val sentence = "one.wpilog: the Driver Station log 2026_03_07 10_04_05 Sat.dslog may belong to this robot, or to the robot of two.wpilog"
            for (command in listOf(listOf("info"), listOf("report", "--no-cache"), listOf("export", "-o", folder / "p.html"), listOf("merge", "-o", folder / "m.wpilog"))) {
                val ended = badlog(command[0], one, "--with-ds=$stations", *command.drop(1).toTypedArray())
                withClue(command) { ended.oneLine() shouldContain sentence }
            }
            (folder / "m.wpilog").exists() shouldBe false
            badlog("info", one, two, "--with-ds=$stations", "--json").out shouldNotContain "Driver Station/Battery Voltage"
            two.toFile().delete()
            badlog("info", one, "--with-ds=$stations", "--json").out shouldContain "Driver Station/Battery Voltage"
        }
    }
})
