package badlog.cli.merge

import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.readBytes

/** The ZIP of a match that merge writes. */
class MergedZipSpec : FunSpec({
    test("a ZIP that would not open as one match is not written") {
        inFolder { folder ->
            // A program that was started again.
            val (one, two) = folder.robot("first.wpilog", "Arm", 0.0) to folder.robot("second.wpilog", "Arm", 0.0)
            val ended = badlog("merge", one, two, "-o", folder / "m.zip")
            ended.code shouldBe ExitCode.NOTHING
            ended.oneLine() shouldContain "use --align enabled, or --offset $two=SECONDS"
            (folder / "m.zip").exists() shouldBe false
            badlog("merge", one, two, "--offset", "second.wpilog=40", "-o", folder / "m.zip").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "m.zip").code shouldBe ExitCode.WHOLE
        }
    }

    test("merge never overwrites a log that it reads: of a match.json, one of its folder, a second file, or a Driver Station's that it searches") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            val robots = (day / "robots").createDirectory()
            val logs = listOf(robots.robot("r.wpilog", "Arm", 0.0), robots.robot("e.dat", "Eye", 0.0))
            day.with("match.json", "{\"version\":1,\"files\":[{\"name\":\"robots/r.wpilog\",\"seconds\":0},{\"name\":\"robots/e.dat\",\"seconds\":1}]}")
            val stations = (folder / "ds").createDirectory()
            val station = stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val events = stations.with("2026_03_07 10_04_05 Sat.dsevents", ByteArray(20))
            val robot = folder.robot("robot.wpilog", "Arm", 0.0)
            val beside = stations.robot("beside.wpilog", "Arm", 0.0)
            val tried = logs.flatMap { log -> listOf(day / "match.json", day).map { listOf<Any>("merge", it, "-o", log) } } +
                listOf(station, events).flatMap { log ->
                    listOf<List<Any>>(
                        listOf("merge", robot, "--with-ds=$stations", "-o", log),
                        listOf("merge", beside, "--with-ds", "-o", log),
                        listOf("export", robot, "--with-ds=$stations", "-o", log),
                    )
                } + listOf(listOf<Any>("merge", day, robot, "-o", day / "match.json"))
            val before = (logs + listOf(station, events, day / "match.json")).associateWith { it.readBytes().toList() }
            for (arguments in tried) {
                val ended = badlog(*arguments.toTypedArray(), "--force")
                withClue(arguments) {
                    ended.code shouldBe ExitCode.NOTHING
                    ended.oneLine() shouldContain "would overwrite a file that is read"
                    before.keys.associateWith { it.readBytes().toList() } shouldBe before
                }
            }
        }
    }

    fun stated(zip: Path): Map<String, Double?> = ZipFile(zip.toFile()).use { file ->
        val text = file.getInputStream(file.getEntry("match.json")).readBytes().decodeToString()
        Json.parseToJsonElement(text).jsonObject.getValue("files").jsonArray.map { it.jsonObject }
            .associate { it.getValue("name").jsonPrimitive.content to it["seconds"]?.jsonPrimitive?.double }
    }

    test("a ZIP states only clocks that are given or found, and the others are found when it is read") {
        inFolder { folder ->
            // On clocks that are 12 s apart, as only their moments of enabling show.
            val logs = listOf(folder.robot("arm_Q3.wpilog", "Arm", -10.0), folder.robot("eye_Q3.wpilog", "Eye", 2.0))
            val zip = folder / "m.zip"
            val ended = badlog("merge", *logs.toTypedArray(), "-o", zip)
            ended.oneLine() shouldContain "open: ${logs[1]}; its clock is found when the ZIP is read"
            stated(zip) shouldBe mapOf("arm_Q3.wpilog" to 0.0, "eye_Q3.wpilog" to null)
            badlog("info", zip).oneLine() shouldContain "Files/eye_Q3.wpilog robot: moved by 12.0 s; 4 edges of enabled fit"
            badlog("merge", *logs.toTypedArray(), "--offset", "eye_Q3.wpilog=0", "-o", zip, "--force").oneLine() shouldNotContain "open:"
            stated(zip) shouldBe mapOf("arm_Q3.wpilog" to 0.0, "eye_Q3.wpilog" to 0.0)
        }
    }

    test("a ZIP has the clock of the robot's log that began first, so that no sample is before 0") {
        inFolder { folder ->
            val (arm, eye) = folder.robot("arm.wpilog", "Arm", 0.0) to folder.robot("eye.wpilog", "Eye", 0.0)
            val zip = folder / "m.zip"
            badlog("merge", arm, eye, "--offset", "arm.wpilog=4", "-o", zip).code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("arm.wpilog" to 4.0, "eye.wpilog" to 0.0)
            badlog("merge", arm, eye, "--align", "enabled", "--offset", "arm.wpilog=4", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip).values.toSet() shouldBe setOf(0.0)
            val late = folder.robot("late.wpilog", "Leg", 3.0)
            badlog("merge", eye, late, "--align", "enabled", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("eye.wpilog" to 0.0, "late.wpilog" to 3.0)
            val early = folder.robot("zoo.wpilog", "Zoo", -3.0)
            badlog("merge", eye, early, "--align", "enabled", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("eye.wpilog" to 3.0, "zoo.wpilog" to 0.0)
            badlog("info", zip).oneLine() shouldNotContain "left out"
        }
    }

    test("a log without the name of a log is opened in the ZIP that merge writes") {
        inFolder { folder ->
            val arm = folder.robot("arm.wpilog", "Arm", 0.0)
            val ended = badlog("merge", arm, folder.robot("robot", "Leg", 0.0), "--align", "enabled", "-o", folder / "m.zip")
            ended.code shouldBe ExitCode.WHOLE
            badlogJson("info", folder / "m.zip").json.single().topics() shouldContain "robot/Leg/Angle"
        }
    }

    test("merge reads a ZIP of a match, beside other logs or alone, and makes no ZIP of it") {
        inFolder { folder ->
            val (arm, eye) = folder.robot("arm.wpilog", "Arm", -10.0) to folder.robot("eye.wpilog", "Eye", 2.0)
            badlog("merge", arm, eye, "--align", "enabled", "-o", folder / "match.zip").code shouldBe ExitCode.WHOLE
            val alone = badlog("merge", folder / "match.zip", "-o", folder / "alone.wpilog")
            alone.code shouldBe ExitCode.WHOLE
            val expected = badlogJson("info", folder / "match.zip").json.single()
            badlogJson("info", folder / "alone.wpilog").json.single().topics() shouldBe expected.topics()
            folder.robot("leg.wpilog", "Leg", -1.0)
            val json = badlogJson("merge", folder / "match.zip", folder / "leg.wpilog", "--align", "enabled", "-o", folder / "all.wpilog").json.single()
            json.getValue("moved").jsonArray.size shouldBe 1
            badlogJson("info", folder / "all.wpilog").json.single().topics() shouldContain "/Leg/Angle"
            badlog("merge", folder / "match.zip", folder / "leg.wpilog", "-o", folder / "more.zip").oneLine() shouldContain "name them to make one ZIP"
            badlog("info", folder / "match.zip", "--with-ds").oneLine() shouldContain "--with-ds has no effect on a ZIP"
        }
    }

    test("a ZIP takes no option that changes logs, and needs a robot's log") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0)
            for (option in listOf(listOf("--append"), listOf("--join"), listOf("--x", "Time"))) {
                badlog("merge", log, folder.robot("eye.wpilog", "Eye", 0.0), *option.toTypedArray(), "-o", folder / "m.zip").run {
                    code shouldBe ExitCode.USAGE
                    oneLine() shouldContain "A ZIP has the logs as they are"
                }
            }
            val stations = listOf("a.dslog", "b.dslog").map { folder.with(it, stationLog().bytes) }
            badlog("merge", *stations.toTypedArray(), "-o", folder / "m.zip").oneLine() shouldContain "needs a robot's log"
            (folder / "m.zip").exists() shouldBe false
        }
    }

    test("a robot's log that is named after the time and is moved makes a ZIP with a Driver Station's log whose clock is open") {
        inFolder { folder ->
            val robot = folder.robot("FRC_20260307_150405.wpilog", "Arm", 0.0)
            val station = folder.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val ended = badlog("merge", robot, station, "--offset", "${robot.fileName}=10", "-o", folder / "m.zip")
            withClue(ended.oneLine()) { ended.code shouldBe ExitCode.WHOLE }
            badlogJson("info", folder / "m.zip").json.single().topics() shouldContain "Driver Station/Battery Voltage"
        }
    }
})
