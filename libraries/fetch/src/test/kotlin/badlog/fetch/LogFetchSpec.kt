package badlog.fetch

import badlog.core.waiting.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.security.KeyPair
import java.time.Duration
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import kotlin.io.path.appendText
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** A pit laptop with a folder for logs, beside a robot. */
internal class Pit(private val work: Path) {
    val folder: Path = work / "logs"
    val hosts = KnownHosts(work / "known_hosts")
    val person = Person()

    fun fetch(robot: FakeRobot, reports: FetchReports = FetchReports(), options: FetchOptions = options(), person: FetchQuestions = this.person) = LogFetch(listOf(robot.address()), options, hosts, person, IMPATIENCE).run(reports)

    fun options(deleteOlderThan: Duration? = null, anyway: Boolean = true, password: String? = null, accepts: Boolean = false, folders: List<String>? = null) = FetchOptions(folder, folders, anyway, deleteOlderThan = deleteOlderThan, password = password, acceptsNewHostKeys = accepts)

    /** Returns all logs here, relative to the folder. */
    fun logs(): List<String> = files().filter { !it.substringAfterLast('/').startsWith(".") }

    /** Returns the hidden files besides the list of fetched logs. */
    fun parts(): List<String> = files().filter { it.endsWith(".part") }

    private fun files() = Files.walk(folder).use { all ->
        all.filter(Files::isRegularFile).map { folder.relativize(it).joinToString("/") }.toList().sorted()
    }
}

internal fun inPit(robotKey: KeyPair = FakeRobot.newKey(), passwords: Map<String, String> = mapOf("lvuser" to ""), work: (Pit, FakeRobot) -> Unit) {
    val folder = Files.createTempDirectory("badlog")
    try {
        FakeRobot(folder / "disk", robotKey, passwords).use { work(Pit(folder), it) }
    } finally {
        folder.toFile().deleteRecursively()
    }
}

/** Symbolic links: on Windows only administrators can create them. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

/** Returns whether this thread waits within [function] of [type]. */
private fun Thread.isIn(type: Class<*>, function: String) = state == Thread.State.WAITING && stackTrace.any { it.className == type.name && it.methodName == function }

@Tags("InCheck")
class LogFetchSpec : FunSpec({
    test("complete logs are fetched, the newest first, sorted by event and named by match, and the robot keeps them") {
        inPit { pit, robot ->
            robot.log("match.bag", matchBag(42), secondsAgo = 100)
            robot.log("FRC_20260316_104107_MILLC_Q41.bag", matchBag(41), secondsAgo = 900)
            robot.log("bench.csv", "a,b\n1,2\n3,4\n", secondsAgo = 1000)
            robot.log("notes.txt", "no log")
            val reports = FetchReports()
            val summary = pit.fetch(robot, reports)
            pit.logs() shouldContainExactly listOf("MILLC/FRC_20260316_104107_MILLC_Q41.bag", "MILLC/match Qualification 42.bag", "bench.csv")
            (pit.folder / "MILLC" / "match Qualification 42.bag").readText() shouldBe matchBag(42)
            summary.fetched.map { it.title } shouldContainExactly listOf("MILLC Qualification 42", "MILLC Qualification 41", null)
            reports.said.take(2) shouldContainExactly listOf("connected to 10.10.14.2 as lvuser", "found 3 new, 0 known")
            val times = listOf("MILLC/FRC_20260316_104107_MILLC_Q41.bag", "MILLC/match Qualification 42.bag", "bench.csv").map { name ->
                Duration.between(Files.getLastModifiedTime(pit.folder / name).toInstant(), robot.start).toSeconds()
            }
            times shouldContainExactly listOf(900, 100, 1000)
            robot.log("x", "").parent.toFile().list()!!.size shouldBe 5
        }
    }

    test("only new logs are fetched, also if a log was removed here") {
        inPit { pit, robot ->
            robot.log("a.bag", matchBag(1))
            pit.fetch(robot)
            Files.delete(pit.folder / "MILLC" / "a Qualification 1.bag")
            robot.log("b.bag", matchBag(2))
            val reports = FetchReports()
            pit.fetch(robot, reports).fetched.map { it.file.name } shouldContainExactly listOf("b Qualification 2.bag")
            reports.said shouldContain "found 1 new, 1 known"
        }
    }

    test("a log replaced on the robot is a second log here, and a log that has grown replaces its copy") {
        inPit { pit, robot ->
            robot.log("match.bag", matchBag(1, rows = 2000))
            pit.fetch(robot)
            robot.log("match.bag", matchBag(1, rows = 3000), secondsAgo = 50)
            val reports = FetchReports()
            pit.fetch(robot, reports)
            pit.logs() shouldContainExactly listOf("MILLC/match Qualification 1.bag")
            reports.said.last() shouldBe "fetched /home/lvuser/logs/match.bag from ${matchBag(1, rows = 2000).length}"
            (pit.folder / "MILLC/match Qualification 1.bag").readText() shouldBe matchBag(1, rows = 3000)
            robot.log("match.bag", matchBag(2, rows = 4000), secondsAgo = 20)
            pit.fetch(robot)
            pit.logs() shouldContainExactly listOf("MILLC/match Qualification 1.bag", "MILLC/match Qualification 2.bag")
        }
    }

    test("two robots' logs of the same name are both kept, and the same log from two robots once") {
        inPit { pit, one ->
            inPit { other, two ->
                one.log("log.csv", "a,b\n1,2\n")
                two.log("log.csv", "a,b\n3,4\n")
                one.log("same.csv", "a,b\n5,6\n")
                two.log("same.csv", "a,b\n5,6\n")
                pit.fetch(one)
                pit.fetch(two)
                pit.logs() shouldContainExactly listOf("log (2).csv", "log.csv", "same.csv")
                other.folder.exists() shouldBe false
            }
        }
    }

    test("a growing log is skipped") {
        inPit { pit, robot ->
            val log = robot.log("now.bag", matchBag(1))
            robot.log("before.bag", matchBag(2))
            val reports = object : FetchListener {
                val said = ArrayList<String>()

                override fun found(logs: FoundLogs) = log.appendText("1,2\n")

                override fun skipped(path: String, message: String, isGrowing: Boolean) {
                    said += "$isGrowing $message"
                }
            }
            val summary = LogFetch(listOf(robot.address()), pit.options(), pit.hosts, pit.person, IMPATIENCE).run(reports)
            summary.fetched.map { it.path } shouldContainExactly listOf("/home/lvuser/logs/before.bag")
            reports.said.single() shouldContain "true /home/lvuser/logs/now.bag is still being written"
        }
    }

    test("a log that grows during its copy is skipped, and its part is resumed") {
        inPit { pit, robot ->
            val log = robot.log("now.csv", "a,b\n" + "1,2\n".repeat(50_000))
            robot.beforePiece = { before -> if (before == 0L) log.appendText("3,4\n") }
            pit.fetch(robot).fetched.shouldBeEmpty()
            pit.logs().shouldBeEmpty()
            robot.beforePiece = {}
            pit.fetch(robot).fetched.single().resumedAt shouldBe 200_004
            (pit.folder / "now.csv").readText() shouldBe log.readText()
        }
    }

    test("a file that is not a log is copied, too, and reported as such") {
        inPit { pit, robot ->
            robot.log("broken.wpilog", ByteArray(500))
            pit.fetch(robot).fetched.single().isLog shouldBe false
            pit.logs() shouldContainExactly listOf("broken.wpilog")
        }
    }

    test("only logs that are old and safely here are removed from the robot") {
        inPit { pit, robot ->
            val day = 24 * 3600L
            robot.log("old.csv", "a,b\n1,2\n", 20 * day)
            robot.log("lost.csv", "a,b\n3,4\n", 20 * day)
            robot.log("changed.csv", "a,b\n7,8\n", 20 * day)
            robot.log("young.csv", "a,b\n5,6\n", day)
            robot.log("wrong-clock.csv", "a,b\n9,9\n", robot.start.epochSecond)
            pit.fetch(robot)
            Files.delete(pit.folder / "lost.csv")
            (pit.folder / "changed.csv").writeText("a,b\n7,9\n")
            val reports = FetchReports()
            pit.fetch(robot, reports, pit.options(deleteOlderThan = Duration.ofDays(14)))
            reports.said.filter { it.startsWith("deleted") } shouldContainExactly listOf("deleted /home/lvuser/logs/old.csv")
            pit.logs() shouldContain "old.csv"
        }
    }

    test("a known robot is trusted at any address without a second question, and a changed key is reported as changed") {
        val disk = Files.createTempDirectory("badlog")
        try {
            val pit = Pit(disk)
            val key = FakeRobot.newKey()
            FakeRobot(disk / "disk", key).use { pit.fetch(it) }
            FakeRobot(disk / "disk", key).use { pit.fetch(it) }
            pit.person.questions shouldContainExactly listOf("unknown")
            FakeRobot(disk / "disk").use { robot ->
                pit.hosts.trust(robot.address(), "ecdsa-sha2-nistp256 another")
                pit.fetch(robot)
                pit.person.questions.last() shouldBe "changed"
                pit.fetch(robot)
                pit.person.questions.size shouldBe 2
            }
        } finally {
            disk.toFile().deleteRecursively()
        }
    }

    test("a robot that is not trusted gets no password") {
        inPit { pit, robot ->
            val error = shouldThrow<HostKeyRefusedException> { pit.fetch(robot, person = FetchQuestions.NOBODY) }
            error.message shouldContain "The host key of 10.10.14.2 is unknown (SHA256:"
            error.message shouldContain "--accept-new-host-key"
            robot.users.shouldBeEmpty()
            pit.fetch(robot, options = pit.options(accepts = true), person = FetchQuestions.NOBODY)
            pit.fetch(robot, person = FetchQuestions.NOBODY)
        }
    }

    test("users are tried in their order, then a person is asked for the password, which appears in no text") {
        inPit(passwords = mapOf("systemcore" to "systemcore")) { pit, robot ->
            pit.fetch(robot).user shouldBe "systemcore"
            robot.users.distinct() shouldContainExactly listOf("lvuser", "systemcore")
        }
        inPit(passwords = mapOf("lvuser" to "secret")) { pit, robot ->
            pit.fetch(robot, options = pit.options(password = "secret")).user shouldBe "lvuser"
            val person = Person(password = "secret")
            pit.fetch(robot, person = person).user shouldBe "lvuser"
            person.questions shouldContainExactly listOf("password of lvuser")
            shouldThrow<LoginRefusedException> { pit.fetch(robot, options = pit.options(password = "wrong")) }.message.let { said ->
                said shouldContain "refuses the password of lvuser and systemcore"
                said shouldNotContain "wrong"
            }
        }
    }

    test("the first address that answers is used, and if none does, the error names all") {
        inPit { pit, robot ->
            val none = RobotAddress("127.0.0.1", listOf(Login("lvuser", "")), port = 1, name = "robot.local")
            LogFetch(listOf(none, robot.address()), pit.options(), pit.hosts, pit.person, IMPATIENCE).run(FetchReports()).address.name shouldBe "10.10.14.2"
            val error = shouldThrow<NoRobotException> { LogFetch(listOf(none, none), pit.options(), pit.hosts, pit.person, IMPATIENCE).run(FetchReports()) }
            error.message shouldContain "No robot answers at robot.local, robot.local"
        }
    }

    test("nothing is fetched while the robot is enabled, and an interrupted copy resumes") {
        inPit { pit, robot ->
            DriverStation().use { station ->
                val content = "a,b\n" + "1,2\n".repeat(100_000)
                robot.log("log.csv", content)
                val states = ArrayList<RobotState>()
                val logins = AtomicInteger()
                val reports = FetchReports(
                    onWaiting = {
                        pit.logs().shouldBeEmpty()
                        val fetching = Thread.currentThread()
                        thread {
                            eventually("the fetch to wait for the robot") { fetching.isIn(RobotState::class.java, "awaitDisabled") }
                            logins.set(robot.users.size)
                            station.isEnabled = false
                        }
                    },
                ) { done ->
                    if (done > 100_000 && logins.get() == 0) {
                        station.isEnabled = true
                        eventually("the news to arrive") { states.single().isEnabled }
                    }
                }
                val fetch = LogFetch(listOf(robot.address(station.port)), pit.options(anyway = false), pit.hosts, pit.person, IMPATIENCE) {
                    RobotState(it, IMPATIENCE.state).also(states::add)
                }
                val log = fetch.run(reports).fetched.single()
                reports.said.count { it == "waiting" } shouldBe 1
                logins.get() shouldBe 1
                (log.resumedAt > 100_000) shouldBe true
                log.file.readText() shouldBe content
            }
        }
    }

    test("a robot that does not report whether it is enabled gets no login") {
        inPit { pit, robot ->
            robot.log("a.csv", "a,b\n1,2\n")
            val error = shouldThrow<UnknownStateException> { pit.fetch(robot, options = pit.options(anyway = false)) }
            error.message shouldContain "its NetworkTables do not answer. Start its program, or use --anyway."
            robot.users.shouldBeEmpty()
        }
    }

    test("bags of programs with the original badlog are found in its folder, the home and the stick, and named by values and times") {
        inPit { pit, robot ->
            fun bag(match: String, start: String) = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]}],\"values\":[{\"name\":\"Start Time\",\"value\":\"$start\"}," +
                "{\"name\":\"Event Name\",\"value\":\"\"},{\"name\":\"Match Type\",\"value\":\"None\"},{\"name\":\"Match Number\",\"value\":\"$match\"}]}\nTime\n1\n2\n"
            robot.log("../log/8D941BF1.bag", bag("12", "Fri, 16 Mar 2018 10:41:07 -0400"))
            robot.log("../96E92E8D.bag", bag("0", "16 Mar 2018 10:41:07"))
            robot.log("../../../media/sda1/ADE8857B.bag", bag("0", "nobody knows"))
            robot.log("../deploy/path.bag", "a,b\n1,2\n")
            robot.log("../settings.csv", "a,b\n1,2\n")
            pit.fetch(robot)
            pit.logs() shouldContainExactlyInAnyOrder listOf("8D941BF1 Match 12.bag", "96E92E8D 2018-03-16 10-41.bag", "ADE8857B.bag")
        }
    }

    test("each folder is searched once, with its subfolders").config(enabledOrReasonIf = { IF_LINKS }) {
        inPit { pit, robot ->
            val log = robot.log("practice/a.csv", "a,b\n1,2\n")
            Files.createSymbolicLink(log.parent.parent.parent / "again", log.parent.parent)
            pit.fetch(robot, options = pit.options(folders = listOf("/home/lvuser/logs", "/home/lvuser/logs", "/nowhere")))
            pit.logs() shouldContainExactlyInAnyOrder listOf("a.csv")
        }
    }
})
