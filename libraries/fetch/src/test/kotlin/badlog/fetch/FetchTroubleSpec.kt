package badlog.fetch

import badlog.file.UnwritableFileException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.time.Duration
import kotlin.io.path.appendText
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

private val LARGE = "a,b\n" + "1,2\n".repeat(500_000)

class FetchTroubleSpec : FunSpec({
    test("a connection that is lost in the middle is tried again, and the copy goes on where it was") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            robot.endsAfter = 1_000_000
            val heard = Heard()
            val log = pit.fetch(robot, heard).fetched.single()
            heard.said shouldContain "retrying"
            log.resumedAt shouldBeGreaterThan 0
            log.file.readText() shouldBe LARGE
            pit.parts().shouldBeEmpty()
        }
    }

    test("a robot that falls silent is given up, without a log that is not whole; the next fetch goes on") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            robot.stallsAfter = 500_000
            val patience = Patience(silence = Duration.ofMillis(400), growth = Duration.ofMillis(10), retry = Duration.ofMillis(10))
            val fetch = LogFetch(listOf(robot.address()), pit.options(), pit.hosts, pit.person, patience)
            shouldThrow<LostConnectionException> { fetch.run(Heard()) }.message shouldContain "which goes on where it stopped"
            pit.logs().shouldBeEmpty()
            pit.parts() shouldHaveSize 1
        }
    }

    test("an end of the program leaves a part, and the next fetch goes on with it") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            class End : Exception()
            shouldThrow<End> { pit.fetch(robot, Heard { done -> if (done > 300_000) throw End() }) }
            pit.logs().shouldBeEmpty()
            val before = robot.servedBytes
            val log = pit.fetch(robot).fetched.single()
            log.resumedAt shouldBeGreaterThan 300_000
            log.file.readText() shouldBe LARGE
            (robot.servedBytes - before < LARGE.length) shouldBe true
        }
    }

    test("a part of a log that was written anew is not gone on with") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            class End : Exception()
            shouldThrow<End> { pit.fetch(robot, Heard { done -> if (done > 300_000) throw End() }) }
            val other = LARGE.replace('1', '7')
            robot.log("log.csv", other)
            pit.fetch(robot).fetched.single().file.readText() shouldBe other
        }
    }

    test("an interruption ends a fetch") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            val me = Thread.currentThread()
            shouldThrow<InterruptedException> { pit.fetch(robot, Heard { done -> if (done > 100_000) me.interrupt() }) }
            pit.logs().shouldBeEmpty()
        }
    }

    test("a log that does not fit the disk is not begun") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            Files.createDirectories(pit.folder)
            RobotLogin(pit.hosts, pit.person, true, null, IMPATIENCE).use { login ->
                login.into(robot.address()).use { connection ->
                    val copy = LogCopy(pit.folder, BandwidthLimit(null), room = { 1_000_000 }) {}
                    val log = connection.list(listOf("/home/lvuser/logs")).logs.single()
                    shouldThrow<NoRoomException> { copy.copy(connection, log, null) {} }.message shouldBe
                        "log.csv needs 3 MB, and the disk of ${pit.folder} has 1 MB left; make room, or select another disk."
                }
            }
            pit.parts().shouldBeEmpty()
        }
    }

    test("names that reach elsewhere, break lines or cannot be on this system stay in the folder") {
        inPit { pit, robot ->
            robot.log("two\nlines.csv", "a,b\n3,4\n")
            robot.log("CON.csv", "a,b\n5,6\n")
            robot.log("a".repeat(240) + ".csv", "a,b\n7,8\n")
            robot.log("bag.bag", matchBag(1).replace("MILLC", "../../up"))
            robot.log("up.csv", "a,b\n1,2\n")
            robot.nameInListing = { if (it == "up.csv") "../up.csv" else it }
            val heard = Heard()
            pit.fetch(robot, heard)
            pit.logs() shouldContainExactly
                listOf("_._.._up/bag Qualification 1.bag", "_CON.csv", "a".repeat(176) + ".csv", "two_lines.csv")
            heard.said shouldContain "“_._up.csv” is not the name of a file in a folder."
            heard.said.none { '\n' in it } shouldBe true
        }
    }

    test("10,000 logs are listed, and those that are here do not come again") {
        inPit { pit, robot ->
            val names = (0 until 10_000).map { "log$it.csv" }
            for (name in names) robot.log(name, "")
            val listing = RobotLogin(pit.hosts, pit.person, true, null, IMPATIENCE).use { login ->
                login.into(robot.address()).use { it to it.list(listOf("/home/lvuser/logs")) }
            }
            listing.second.logs shouldHaveSize 10_000
            FetchedLogs.open(pit.folder).use { here ->
                for (log in listing.second.logs.drop(1)) here.add(LogHere(listing.first.robot, log.path, log.size, log.modified, log.name, "", 0))
            }
            pit.fetch(robot).known shouldBe 9_999
        }
    }

    test("a list of fetched logs with half a line is read and gone on with") {
        inPit { pit, robot ->
            robot.log("a.csv", "a,b\n1,2\n")
            pit.fetch(robot)
            (pit.folder / ".badlog-fetched.jsonl").appendText("{\"robot\":\"x")
            robot.log("b.csv", "a,b\n3,4\n")
            pit.fetch(robot).fetched.map { it.file.name } shouldContainExactly listOf("b.csv")
            pit.fetch(robot).known shouldBe 2
        }
    }

    test("two programs do not fetch into one folder at a time") {
        inPit { pit, robot ->
            FetchedLogs.open(pit.folder).use {
                shouldThrow<NoRoomException> { pit.fetch(robot) }.message shouldContain "Another badlog is fetching into"
            }
        }
    }

    test("a folder that is a file is one sentence") {
        inPit { pit, robot ->
            pit.folder.writeText("")
            shouldThrow<UnwritableFileException> { pit.fetch(robot) }.message shouldContain "select another"
        }
    }
})
