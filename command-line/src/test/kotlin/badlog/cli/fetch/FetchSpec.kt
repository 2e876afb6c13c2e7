package badlog.cli.fetch

import badlog.cli.badlogBeside
import badlog.cli.besideRobot
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.core.waiting.eventually
import badlog.fetch.FakeRobot
import badlog.fetch.IMPATIENCE
import badlog.fetch.matchBag
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import kotlinx.serialization.json.long
import java.time.Duration
import kotlin.concurrent.thread
import kotlin.io.path.div

@Tags("InCheck")
class FetchSpec : FunSpec({
    test("new logs are fetched and reported; without new logs, fetch succeeds") {
        besideRobot { robot, robots ->
            inFolder { folder ->
                robot.log("match.bag", matchBag(42))
                val ended = badlogBeside(robots, "fetch", "1014", "--out", folder, "--accept-new-host-key")
                ended.code shouldBe ExitCode.WHOLE
                ended.out shouldBe "${folder / "MILLC" / "match Qualification 42.bag"}: MILLC Qualification 42, ${matchBag(42).length} bytes\n"
                ended.err shouldBe "Connected to 10.10.14.2 as lvuser.\n1 new log, ${matchBag(42).length} bytes.\n"
                val again = badlogBeside(robots, "fetch", "1014", "--out", folder)
                again.code shouldBe ExitCode.WHOLE
                again.out shouldBe ""
                again.err shouldContain "Nothing new on 10.10.14.2; 1 log fetched before.\n"
            }
        }
    }

    test("a program gets a line for each log, or the reason for a failure") {
        besideRobot { robot, robots ->
            inFolder { folder ->
                val refused = badlogBeside(robots, "fetch", "1014", "--out", folder, "--json")
                refused.code shouldBe ExitCode.NOTHING
                refused.err shouldBe ""
                refused.json.single().getValue("error").jsonPrimitive.content shouldContain "is unknown (SHA256:"
                robot.log("match.bag", matchBag(42))
                val line = badlogBeside(robots, "fetch", "1014", "--out", folder, "--json", "--accept-new-host-key").json.single()
                line.getValue("status").jsonPrimitive.content shouldBe "whole"
                line.getValue("path").jsonPrimitive.content shouldBe "/home/lvuser/logs/match.bag"
                line.getValue("match").jsonPrimitive.content shouldBe "MILLC Qualification 42"
                line.getValue("bytes").jsonPrimitive.long shouldBe matchBag(42).length
            }
        }
    }

    test("a damaged log is fetched, and the exit code shows the loss") {
        besideRobot { robot, robots ->
            inFolder { folder ->
                robot.log("cut.bag", matchBag(42).dropLast(3))
                robot.log("zeros.wpilog", ByteArray(100))
                val ended = badlogBeside(robots, "fetch", "1014", "--out", folder, "--accept-new-host-key")
                ended.code shouldBe ExitCode.SALVAGED
                ended.out shouldContain "damaged; badlog info says what is lost"
                ended.out shouldContain "cannot be read; badlog info says why"
            }
        }
    }

    test("a robot that does not say whether it is enabled is one sentence, and --anyway copies") {
        inFolder { folder ->
            FakeRobot(folder / "disk").use { robot ->
                robot.log("match.bag", matchBag(42))
                val robots = Robots({ _, _ -> listOf(robot.address()) }, { folder / "settings" }, password = null, IMPATIENCE)
                val arguments = arrayOf("fetch", "1014", "--out", folder / "logs", "--accept-new-host-key")
                val ended = badlogBeside(robots, *arguments)
                ended.code shouldBe ExitCode.NOTHING
                ended.err shouldContain "use --anyway.\n"
                ended.err.lines().size shouldBe 2
                badlogBeside(robots, *arguments, "--anyway", "--limit", "50MB/s").code shouldBe ExitCode.WHOLE
            }
        }
    }

    test("--watch fetches until it is interrupted") {
        besideRobot { robot, robots ->
            inFolder { folder ->
                robot.log("a.bag", matchBag(1))
                val ended = ArrayList<ExitCode>()
                val watching = thread {
                    ended += badlogBeside(robots, "fetch", "1014", "--out", folder, "--accept-new-host-key", "--watch").code
                }
                // An end while the log is noted would be another one.
                eventually("the log") { (folder / "MILLC").names().isNotEmpty() && robot.connections == 0 }
                eventually("the end") {
                    watching.interrupt()
                    !watching.isAlive
                }
                ended shouldContainExactly listOf(ExitCode.WHOLE)
            }
        }
    }

    test("a password comes from the environment, and no text shows it") {
        inFolder { folder ->
            FakeRobot(folder / "disk", passwords = mapOf("lvuser" to "secret")).use { robot ->
                fun robots(password: String) = Robots({ _, _ -> listOf(robot.address()) }, { folder / "settings" }, password, IMPATIENCE)
                val arguments = arrayOf("fetch", "1014", "--out", folder / "logs", "--accept-new-host-key", "--anyway")
                badlogBeside(robots("secret"), *arguments).code shouldBe ExitCode.WHOLE
                val refused = badlogBeside(robots("hidden"), *arguments)
                refused.err shouldContain "refuses the password of lvuser and systemcore"
                refused.err shouldNotContain "hidden"
            }
        }
    }

    test("rates and ages are read as they are typed") {
        rateOf("2MB/s") shouldBe 2_000_000
        rateOf("500k") shouldBe 500_000
        rateOf("1.5 MB/s") shouldBe 1_500_000
        for (wrong in listOf("0", "fast", "-1", "1e9", "MB")) rateOf(wrong) shouldBe null
        ageOf("14d") shouldBe Duration.ofDays(14)
        ageOf("36h") shouldBe Duration.ofHours(36)
        for (wrong in listOf("14", "d", "-1d", "2 weeks")) ageOf(wrong) shouldBe null
    }
})
