package badlog.fetch

import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.time.Duration
import java.time.Instant
import java.util.Base64
import kotlin.io.path.appendText
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText

private val LARGE = "a,b\n" + "1,2\n".repeat(500_000)

/** A table of two rows, compressed with xz. */
private val XZ_OF_TABLE = Base64.getDecoder().decode("/Td6WFoAAAFpIt42AgAhAQwAAACPmEGcAQALYSxiCjEsMgozLDQKAOXp1s4AASAMot20vJBCmQ0BAAAAAAFZWg==")

/** Runs [work] while Java's folder for temporary files is [folder]. */
private fun withTemporaryFolder(folder: Path, work: () -> Unit) {
    val before = System.setProperty("java.io.tmpdir", "$folder")
    try {
        work()
    } finally {
        System.setProperty("java.io.tmpdir", before)
    }
}

@Tags("InCheck")
class FetchTroubleSpec : FunSpec({
    test("a lost connection is retried, and the copy resumes") {
        inPit { pit, robot ->
            // More than is requested ahead, so that the connection is lost before the end.
            val content = LARGE.repeat(4)
            robot.log("log.csv", content)
            var isLost = false
            val reports = FetchReports {
                if (!isLost && it > 0) {
                    isLost = true
                    robot.endsAfter = 0
                }
            }
            val log = pit.fetch(robot, reports).fetched.single()
            reports.said.count { it == "retrying" } shouldBe 1
            log.resumedAt shouldBeGreaterThan 0
            log.file.readText() shouldBe content
            pit.parts().shouldBeEmpty()
        }
    }

    test("a silent robot is given up without an incomplete log, and the next fetch resumes") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            val patience = Patience(
                IMPATIENCE.connect,
                IMPATIENCE.answer,
                silence = Duration.ofMillis(400),
                growth = Duration.ofMillis(10),
                retry = Duration.ofMillis(10),
            )
            val fetch = LogFetch(listOf(robot.address()), pit.options(), pit.hosts, pit.person, patience)
            var copied = 0L
            // A busy machine falls silent, too, perhaps before the first byte.
            for (attempt in 1..20) {
                robot.stallsAfter = robot.servedBytes + 500_000
                shouldThrow<LostConnectionException> { fetch.run(FetchReports { copied = it }) }.message shouldContain "fetch again to resume"
                pit.logs().shouldBeEmpty()
                if (copied > 0) break
            }
            copied shouldBeGreaterThan 0
            pit.parts() shouldHaveSize 1
            robot.stallsAfter = Long.MAX_VALUE
            val log = pit.fetch(robot).fetched.single()
            log.resumedAt shouldBe copied
            log.file.readText() shouldBe LARGE
        }
    }

    test("a fetch that ends early leaves a part, and the next fetch resumes it") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            class End : Exception()
            shouldThrow<End> { pit.fetch(robot, FetchReports { done -> if (done > 300_000) throw End() }) }
            pit.logs().shouldBeEmpty()
            val log = pit.fetch(robot).fetched.single()
            log.resumedAt shouldBeGreaterThan 300_000
            log.file.readText() shouldBe LARGE
            // The first connection may receive the bytes that it requested ahead even after its end.
            robot.servedByConnection.last() shouldBeLessThan LARGE.length.toLong()
        }
    }

    test("a part of a log that was rewritten is not resumed") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            class End : Exception()
            shouldThrow<End> { pit.fetch(robot, FetchReports { done -> if (done > 300_000) throw End() }) }
            val other = LARGE.replace('1', '7')
            robot.log("log.csv", other)
            pit.fetch(robot).fetched.single().file.readText() shouldBe other
        }
    }

    test("an interruption ends a fetch") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            val me = Thread.currentThread()
            shouldThrow<InterruptedException> { pit.fetch(robot, FetchReports { done -> if (done > 100_000) me.interrupt() }) }
            pit.logs().shouldBeEmpty()
        }
    }

    test("a log that does not fit the disk is not started") {
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

    test("a disk that becomes full during a copy is reported, and the next fetch resumes") {
        inPit { pit, robot ->
            robot.log("log.csv", LARGE)
            Files.createDirectories(pit.folder)
            RobotLogin(pit.hosts, pit.person, true, null, IMPATIENCE).use { login ->
                login.into(robot.address()).use { connection ->
                    var left = 1_000_000L
                    val copy = LogCopy(pit.folder, BandwidthLimit(null), room = { if (left < 1_000_000) left else 10_000_000 }, write = { file, bytes ->
                        if (bytes.remaining() > left) {
                            left = 0
                            // Like a system that writes the bytes that still fit.
                            file.write(bytes.limit(bytes.position() + 100))
                            throw IOException("No space left on device")
                        }
                        left -= bytes.remaining()
                        while (bytes.hasRemaining()) file.write(bytes)
                    }) {}
                    val log = connection.list(listOf("/home/lvuser/logs")).logs.single()
                    shouldThrow<NoRoomException> { copy.copy(connection, log, null) {} }.message shouldBe
                        "The disk of ${pit.folder} is full, so log.csv is only partly here; make room, then fetch again to resume."
                }
            }
            pit.parts() shouldHaveSize 1
            val log = pit.fetch(robot).fetched.single()
            log.resumedAt shouldBeGreaterThan 900_000
            log.file.readText() shouldBe LARGE
            pit.parts().shouldBeEmpty()
        }
    }

    test("a day after its log was removed from the robot, a part becomes a log, or is removed if it has no samples") {
        inPit { pit, robot ->
            class End : Exception()
            fun cut(name: String, text: String) {
                val log = robot.log(name, text)
                shouldThrow<End> { pit.fetch(robot, FetchReports { done -> if (done > 300_000) throw End() }) }
                Files.delete(log)
            }
            cut("log.csv", LARGE)
            pit.fetch(robot)
            // The robot's stick may be removed for a while.
            pit.parts() shouldHaveSize 1
            cut("noise.csv", "\u0000".repeat(2_000_000))
            for (part in pit.parts()) Files.setLastModifiedTime(pit.folder / part, FileTime.from(Instant.now().minus(Duration.ofHours(25))))
            val reports = FetchReports()
            pit.fetch(robot, reports)
            pit.parts().shouldBeEmpty()
            pit.logs() shouldContainExactly listOf("unfinished.csv")
            LARGE.startsWith((pit.folder / "unfinished.csv").readText()) shouldBe true
            reports.said.count { "no longer on the robot" in it } shouldBe 2
        }
    }

    test("a log without room for temporary files stays a part until it can be read, also if the robot no longer has it") {
        inPit { pit, robot ->
            val log = robot.log("log.wpilogxz", XZ_OF_TABLE)
            val missing = pit.folder / "gone"
            withTemporaryFolder(missing) {
                shouldThrow<UnreadableFileException> { pit.fetch(robot) }.message shouldContain "$missing cannot be written"
                pit.logs().shouldBeEmpty()
                val part = pit.folder / pit.parts().single()
                Files.delete(log)
                Files.setLastModifiedTime(part, FileTime.from(Instant.now().minus(Duration.ofHours(25))))
                val reports = FetchReports()
                pit.fetch(robot, reports)
                pit.parts() shouldContainExactly listOf(part.name)
                reports.said shouldContain "$part: $missing cannot be written: its folder does not exist; create it. " +
                    "The file has the start of a log that is no longer on the robot, and is kept."
            }
            pit.fetch(robot)
            pit.parts().shouldBeEmpty()
            pit.logs() shouldContainExactly listOf("unfinished.csv")
            (pit.folder / "unfinished.csv").readBytes() shouldBe XZ_OF_TABLE
        }
    }

    test("names with paths, with line breaks, or invalid on this system stay in the folder") {
        inPit { pit, robot ->
            robot.log("two\nlines.csv", "a,b\n3,4\n")
            robot.log("CON.csv", "a,b\n5,6\n")
            robot.log("a".repeat(240) + ".csv", "a,b\n7,8\n")
            robot.log("bag.bag", matchBag(1).replace("MILLC", "../../up"))
            robot.log("up.csv", "a,b\n1,2\n")
            robot.nameInListing = { if (it == "up.csv") "../up.csv" else it }
            val reports = FetchReports()
            pit.fetch(robot, reports)
            pit.logs() shouldContainExactly
                listOf("_._.._up/bag Qualification 1.bag", "_CON.csv", "a".repeat(176) + ".csv", "two_lines.csv")
            reports.said shouldContain "“_._up.csv” is not a plain file name."
            reports.said.none { '\n' in it } shouldBe true
        }
    }

    test("10,000 logs are listed, and those already here are not fetched again") {
        inPit { pit, robot ->
            val names = (0 until 10_000).map { "log$it.csv" }
            for (name in names) robot.log(name, "")
            val listing = RobotLogin(pit.hosts, pit.person, true, null, IMPATIENCE).use { login ->
                login.into(robot.address()).use { it to it.list(listOf("/home/lvuser/logs")) }
            }
            listing.second.logs shouldHaveSize 10_000
            FetchedLogs.open(pit.folder).use { here ->
                for (log in listing.second.logs.drop(1)) here.add(CopiedLog(listing.first.robot, log.path, log.size, log.modified, log.name, "", 0))
            }
            pit.fetch(robot).known shouldBe 9_999
        }
    }

    test("a list of fetched logs that ends in half a line is read and continued") {
        inPit { pit, robot ->
            robot.log("a.csv", "a,b\n1,2\n")
            pit.fetch(robot)
            (pit.folder / ".badlog-fetched.jsonl").appendText("{\"robot\":\"x")
            robot.log("b.csv", "a,b\n3,4\n")
            pit.fetch(robot).fetched.map { it.file.name } shouldContainExactly listOf("b.csv")
            pit.fetch(robot).known shouldBe 2
        }
    }

    test("two programs cannot fetch into one folder at the same time") {
        inPit { pit, robot ->
            FetchedLogs.open(pit.folder).use {
                shouldThrow<NoRoomException> { pit.fetch(robot) }.message shouldContain "Another badlog is fetching into"
            }
        }
    }

    test("a file in place of the folder is reported in one sentence") {
        inPit { pit, robot ->
            pit.folder.writeText("")
            shouldThrow<UnwritableFileException> { pit.fetch(robot) }.message shouldContain "is a file, not a folder; rename that file."
        }
    }
})
