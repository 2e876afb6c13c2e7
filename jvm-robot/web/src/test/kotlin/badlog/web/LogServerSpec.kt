package badlog.web

import badlog.core.waiting.eventually
import badlog.formats.LOG_ENDINGS
import edu.wpi.first.wpilibj.DriverStation
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.File
import java.io.RandomAccessFile
import java.net.ServerSocket
import java.nio.file.Files
import java.nio.file.attribute.FileTime
import java.util.zip.GZIPInputStream
import kotlin.io.path.appendText
import kotlin.io.path.createDirectories
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

private val BYTES = ByteArray(100_000) { (it * 31 + it / 251).toByte() }

@Tags("InCheck")
class LogServerSpec : FunSpec({
    test("/ is the page, which may contact only this server, and is not sent twice") {
        withServer { server ->
            val page = server.get("/")
            page.status shouldBe 200
            page.headers["content-encoding"] shouldBe "gzip"
            val text = GZIPInputStream(page.body.inputStream()).readBytes().decodeToString()
            text shouldContain "default-src 'none'"
            text shouldContain "connect-src 'self';"
            text shouldContain "\"network\":\"robot\""
            val again = server.get("/", "If-None-Match: ${page.headers["etag"]}")
            again.status to again.body.size shouldBe (304 to 0)
        }
    }

    test("a listing has folders and logs with sizes and times, in the form of WPILib's server") {
        withServer { server ->
            server.logs.resolve("b.wpilog").writeBytes(BYTES)
            server.logs.resolve("a.bag").writeText("bag")
            server.logs.resolve("day 2").createDirectories()
            server.logs.resolve("a.bag").setLastModifiedTime(FileTime.fromMillis(1_772_892_000_123))
            server.logs.resolve("b.wpilog").setLastModifiedTime(FileTime.fromMillis(1_772_892_132_000))
            server.get("/?format=json").text shouldBe """{"dirs":[{"name":"logs"}],"files":[]}"""
            server.get("/logs/?format=json").text shouldBe
                """{"dirs":[{"name":"day 2"}],"files":[{"name":"a.bag","size":3,"modified":1772892000123},""" +
                """{"name":"b.wpilog","size":100000,"modified":1772892132000}]}"""
        }
    }

    test("a listing has every kind of log that can be read") {
        withServer { server ->
            val names = LOG_ENDINGS.map { "log$it" }
            for (name in names) server.logs.resolve(name).writeText("log")
            val listing = server.get("/logs/?format=json").text
            names.filterNot { "\"$it\"" in listing }.shouldBeEmpty()
        }
    }

    test("folders get distinct names, a folder with two paths gets one, and missing ones are skipped").config(
        enabledOrReasonIf = { IF_UNIX },
    ) {
        val above = Files.createTempDirectory("badlog-web")
        val first = above.resolve("a/logs").createDirectories()
        val second = above.resolve("b/logs").createDirectories()
        second.resolve("x.bag").writeText("x")
        val link = Files.createSymbolicLink(above.resolve("stick"), first)
        val folders = LogFolders(listOf(first, link, second, above.resolve("none")).map { it.toFile() })
        folders.list("/")?.toJson() shouldBe """{"dirs":[{"name":"logs"},{"name":"logs-2"}],"files":[]}"""
        folders.log("/logs-2/x.bag")?.size shouldBe 1
        above.toFile().deleteRecursively()
    }

    test("a home shows only the bags directly in it, and is not listed without any") {
        val above = Files.createTempDirectory("badlog-web")
        val home = above.resolve("lvuser")
        val logs = home.resolve("log").createDirectories()
        home.resolve("deploy").createDirectories().resolve("path.bag").writeText("x")
        home.resolve("settings.csv").writeText("x")
        logs.resolve("8D941BF1.bag").writeText("bag")
        val folders = LogFolders(listOf(logs.toFile()), listOf(home.toFile()))
        folders.list("/")?.toJson() shouldBe """{"dirs":[{"name":"log"}],"files":[]}"""
        home.resolve("96E92E8D.bag").writeText("home")
        folders.list("/")?.toJson() shouldBe """{"dirs":[{"name":"log"},{"name":"lvuser"}],"files":[]}"""
        checkNotNull(folders.list("/lvuser/")).toJson().let { listing ->
            ("96E92E8D.bag" in listing) shouldBe true
            ("settings.csv" in listing || "deploy" in listing) shouldBe false
        }
        folders.log("/lvuser/96E92E8D.bag")?.size shouldBe 4
        folders.log("/log/8D941BF1.bag")?.size shouldBe 3
        for (address in listOf("/lvuser/settings.csv", "/lvuser/deploy/path.bag", "/lvuser/log/8D941BF1.bag")) folders.log(address) shouldBe null
        folders.list("/lvuser/deploy/") shouldBe null
        above.toFile().deleteRecursively()
    }

    test("a folder that appears after the start is served, and the others keep their addresses") {
        val above = Files.createTempDirectory("badlog-web")
        val stick = above.resolve("stick/logs")
        val own = above.resolve("own/logs")
        val folders = LogFolders(listOf(stick, own).map { it.toFile() })
        folders.list("/")?.toJson() shouldBe """{"dirs":[],"files":[]}"""
        own.createDirectories().resolve("x.bag").writeText("x")
        folders.log("/logs/x.bag")?.size shouldBe 1
        stick.createDirectories().resolve("x.bag").writeText("stick")
        folders.list("/")?.toJson() shouldBe """{"dirs":[{"name":"logs"},{"name":"logs-2"}],"files":[]}"""
        folders.log("/logs/x.bag")?.size shouldBe 1
        folders.log("/logs-2/x.bag")?.size shouldBe 5
        stick.toFile().deleteRecursively()
        folders.list("/")?.toJson() shouldBe """{"dirs":[{"name":"logs"}],"files":[]}"""
        above.toFile().deleteRecursively()
    }

    test("a requested part of a log is sent") {
        withServer { server ->
            server.logs.resolve("a.bag").writeBytes(BYTES)
            fun range(value: String) = server.get("/logs/a.bag", "Range: $value")
            fun part(value: String) = range(value).also { it.status shouldBe 206 }.let { it.headers["content-range"] to it.body.toList() }
            part("bytes=0-0") shouldBe ("bytes 0-0/100000" to BYTES.take(1))
            part("bytes=99990-") shouldBe ("bytes 99990-99999/100000" to BYTES.drop(99990))
            part("bytes=-7") shouldBe ("bytes 99993-99999/100000" to BYTES.takeLast(7))
            part("bytes=50000-999999999999999999999999") shouldBe ("bytes 50000-99999/100000" to BYTES.drop(50000))
            part("bytes=-99999999999999999999") shouldBe ("bytes 0-99999/100000" to BYTES.toList())
            for (beyond in listOf("bytes=100000-", "bytes=100000-100001", "bytes=99999999999999999999999-", "bytes=-0")) {
                val answer = range(beyond)
                answer.status to answer.headers["content-range"] shouldBe (416 to "bytes */100000")
            }
            // Ranges that a server may ignore get the whole log, once.
            for (ignored in listOf("bytes=0-1,4-5", "bytes=" + (0..900).joinToString(",") { "0-" }, "bytes=5-1", "bytes=-", "lines=0-1", "bytes=a-b", "bytes=--5")) {
                val answer = range(ignored)
                answer.status to answer.body.size shouldBe (200 to BYTES.size)
            }
        }
    }

    test("an unchanged log is not sent again, and parts of a changed log are not mixed") {
        withServer { server ->
            val log = server.logs.resolve("a.bag").apply { writeText("first") }
            val tag = server.get("/logs/a.bag").headers["etag"]
            server.get("/logs/a.bag", "If-None-Match: $tag").status shouldBe 304
            server.get("/logs/a.bag", "Range: bytes=3-", "If-Range: $tag").text shouldBe "st"
            log.writeText("another one")
            server.get("/logs/a.bag", "If-None-Match: $tag").text shouldBe "another one"
            server.get("/logs/a.bag", "Range: bytes=3-", "If-Range: $tag").text shouldBe "another one"
        }
    }

    test("an empty log is an empty answer") {
        withServer { server ->
            server.logs.resolve("a.bag").writeText("")
            server.get("/logs/a.bag").let { it.status to it.body.size } shouldBe (200 to 0)
        }
    }

    test("a log that becomes shorter while it is sent ends the connection") {
        val clock = TestClock()
        withServer(paced(clock)) { server ->
            val log = server.logs.resolve("a.bag").apply { writeBytes(BYTES) }
            server.connect().use { socket ->
                socket.getOutputStream().write("GET /logs/a.bag HTTP/1.1\r\nHost: localhost\r\n\r\n".encodeToByteArray())
                val stream = socket.getInputStream()
                stream.readNBytes(500).size shouldBe 500
                eventually("the second part, which was read, to wait") { clock.waiting == 1 }
                RandomAccessFile(log.toFile(), "rw").use { it.setLength(20_000) }
                clock.run()
                stream.readBytes().size shouldBeLessThan 40_000
            }
        }
    }

    test("two downloads share one pace; a third one is told to wait, and gets its turn") {
        val clock = TestClock()
        withServer(paced(clock)) { server ->
            server.logs.resolve("a.bag").writeBytes(BYTES)
            val sockets = List(2) { server.connect() }
            for (socket in sockets) {
                socket.getOutputStream().write("GET /logs/a.bag HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encodeToByteArray())
            }
            eventually("both downloads to wait for their turn") { clock.waiting == 2 }
            val third = server.get("/logs/a.bag")
            third.status shouldBe 503
            third.text shouldStartWith "Two downloads are running already"
            // Pages that follow the log learn to try again.
            third.headers["retry-after"] shouldBe "1"
            // Short answers need no place.
            server.get("/logs/?format=json").status shouldBe 200
            clock.run()
            for (socket in sockets) socket.getInputStream().readBytes().takeLast(9) shouldBe BYTES.takeLast(9)
            // Each byte took its time, except for those in the last part. That is the rest of a log after six parts of 16 KiB.
            clock.nanos() shouldBe (200_000 - (100_000 - 6 * 16_384)) * 20_000L
            sockets.forEach { it.close() }
            awaited("a free place") { server.get("/logs/a.bag").takeIf { it.status == 200 } }.body.size shouldBe BYTES.size
        }
    }

    test("on the field nothing is served; while enabled elsewhere, only the end of the running log") {
        val options = LogServerOptions()
        withServer(options) { server ->
            val old = server.logs.resolve("old.bag").apply { writeBytes(BYTES) }
            old.setLastModifiedTime(FileTime.fromMillis(1_772_892_000_000))
            val running = server.logs.resolve("running.bag").apply { writeBytes(ByteArray(2_000_000)) }
            running.appendText("end")
            // In the year 2100, so that the log counts as running throughout the test.
            running.setLastModifiedTime(FileTime.fromMillis(4_102_444_800_000))
            DriverStation.enabled = true
            try {
                for (address in listOf("/", "/?format=json", "/logs/old.bag", "/logs/running.bag")) {
                    val answer = server.get(address)
                    answer.status shouldBe 503
                    answer.text shouldStartWith "The robot is enabled: its logs can be opened once it is disabled."
                }
                server.get("/logs/old.bag", "Range: bytes=-3").status shouldBe 503
                server.get("/logs/running.bag", "Range: bytes=0-").status shouldBe 503
                server.get("/logs/running.bag", "Range: bytes=2000000-").text shouldBe "end"
                server.get("/logs/running.bag", "Range: bytes=500-").text shouldStartWith
                    "The robot is enabled, and Live is more than a megabyte behind: press Live again once it is disabled."
                server.get("/logs/running.bag", "Range: bytes=2000003-").status shouldBe 416
                DriverStation.attached = true
                server.get("/logs/running.bag", "Range: bytes=2000000-").text shouldStartWith "The robot is connected to the field"
                DriverStation.enabled = false
                server.get("/").status shouldBe 503
                DriverStation.attached = false
                server.get("/").status shouldBe 200
                options.isAlwaysOpen = true
                DriverStation.enabled = true
                DriverStation.attached = true
                server.get("/logs/old.bag").status shouldBe 200
            } finally {
                DriverStation.enabled = false
                DriverStation.attached = false
            }
        }
    }

    test("a download ends when the robot is enabled") {
        val clock = TestClock()
        withServer(paced(clock)) { server ->
            server.logs.resolve("a.bag").writeBytes(BYTES)
            server.connect().use { socket ->
                socket.getOutputStream().write("GET /logs/a.bag HTTP/1.1\r\nHost: localhost\r\n\r\n".encodeToByteArray())
                socket.getInputStream().readNBytes(300)
                eventually("the second part to wait") { clock.waiting == 1 }
                DriverStation.enabled = true
                try {
                    clock.run()
                    socket.getInputStream().readBytes().size shouldBeLessThan BYTES.size
                } finally {
                    DriverStation.enabled = false
                }
            }
        }
    }

    test("a port in use gives one message with advice, and the program continues") {
        ServerSocket(0).use { taken ->
            val (exit, output) = outputOf("${taken.localPort}")
            exit shouldBe 0
            output.trim().lines().size shouldBe 1
            output shouldStartWith "badlog: The logs are not shown in browsers: port ${taken.localPort} cannot be opened (Address already in use)."
        }
    }

    test("a Java without the server's module gives one message with advice") {
        val (exit, output) = outputOf("0", "--limit-modules", "java.base,java.logging")
        exit shouldBe 0
        output shouldBe "badlog: The logs are not shown in browsers: it needs the module jdk.httpserver, which this Java lacks. " +
            "Fetch the logs with badlog fetch instead.\n"
    }

    test("the server ends with the program") {
        outputOf("0") shouldBe (0 to "")
    }

    test("a robot gets only the server, its page and Kotlin's library") {
        val jars = System.getProperty("badlog.shipped").split(File.pathSeparator).map(::File).filter { it.exists() }
        jars.map { it.name.substringBeforeLast('-') } shouldContainExactly listOf("web", "kotlin-stdlib", "annotations")
        jars[0].length() shouldBeLessThan 600_000
    }
})

/** Options of a server that sends 50,000 bytes of downloads in a second of [clock]. */
private fun paced(clock: Clock) = LogServerOptions().also {
    it.bytesPerSecond = 50_000
    it.clock = clock
}

/** Runs a robot's program that serves on [port], and ends once the port is opened or refused. Returns its exit code and its output. */
private fun outputOf(port: String, vararg options: String): Pair<Int, String> {
    val java = File(System.getProperty("java.home"), "bin/java").path
    val classpath = System.getProperty("badlog.shipped") + File.pathSeparator + System.getProperty("badlog.robots")
    val process = ProcessBuilder(java, *options, "-cp", classpath, "badlog.robots.ServingRobot", port).redirectErrorStream(true).start()
    val output = process.inputStream.readBytes().decodeToString()
    return process.waitFor() to output
}
