package badlog.window.screen

import badlog.catalog.folder.bag
import badlog.catalog.folder.put
import badlog.window.bagOf
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.nio.file.attribute.PosixFilePermissions

@Tags("InCheck")
class TroubleWindowSpec : FunSpec({
    val large by lazy { largeBag(tempdir().toPath(), "large.bag") }

    test("a window that reads a large file closes at once").config(enabledOrReasonIf = { needsDisplay }) {
        val window = RealWindow(tempdir().toPath(), large)
        window.awaitReading()
        window.close()
    }

    test("a log that is opened while another one is read replaces it").config(enabledOrReasonIf = { needsDisplay }) {
        val small = large.parent.put("small.bag", bag())
        RealWindow(tempdir().toPath(), large).use { window ->
            window.awaitReading()
            window.look { it.loader.open(small) }
            window.awaitState("the small one") { it.current.recording?.file == small && it.tasks.all.isEmpty() }
            window.look { it.current.recording?.file } shouldBe small
        }
    }

    test("a log stays open after its file is deleted, which is reported").config(enabledOrReasonIf = { needsDisplay }) {
        val file = tempdir().toPath().put("match.bag", bag())
        RealWindow(tempdir().toPath(), file).use { window ->
            window.awaitState("the log") { it.current.recording != null }
            window.awaitGraphs()
            Files.delete(file)
            window.awaitSaid("was removed from its folder")
            window.look { it.current.recording?.file } shouldBe file
            window.picture("deleted")
        }
    }

    test("logs with extreme or missing values, names and topics are shown").config(enabledOrReasonIf = { needsDisplay }) {
        val folder = tempdir().toPath()
        val rows = (0 until 100).map { "${it * 0.1},${it % 7}" }
        val topics = listOf("Time|xaxis", "A/Voltage")
        val logs = mapOf(
            "one-row.bag" to bagOf(topics, rows.take(1)),
            "no-rows.bag" to bagOf(topics, emptyList()),
            "no-numbers.bag" to bagOf(topics, (0 until 100).map { "${it * 0.1},NaN" }),
            "no-x.bag" to bagOf(topics, (0 until 100).map { "NaN,$it" }),
            "backwards.bag" to bagOf(topics, rows.reversed()),
            "huge.bag" to bagOf(topics, (0 until 100).map { "${it * 1e300},${if (it % 2 == 0) 1.7e308 else -1.7e308}" }),
            "long-names.bag" to bagOf(
                topics = listOf("Time|xaxis") + (0..3).map { "Folder ${"f".repeat(240)}/${"n".repeat(240)} $it" },
                rows = (0 until 100).map { "${it * 0.1},1,2,3,$it" },
                values = mapOf("Event Name" to "E".repeat(500), "Match Type" to "Qualification", "Match Number" to "1"),
            ),
            "many-topics.bag" to manyTopics(10_000),
        ).map { (name, text) -> folder.put(name, text) }
        RealWindow(tempdir().toPath(), folder).use { window ->
            for (file in logs) {
                window.look { it.loader.open(file) }
                window.awaitState("$file") { it.current.recording?.file == file && it.tasks.all.isEmpty() }
                if (window.look { viewer -> viewer.board.state.graphs.isNotEmpty() && viewer.current.recording?.signals?.isNotEmpty() == true }) {
                    window.awaitGraphs()
                }
                window.picture(file.fileName.toString().removeSuffix(".bag"))
                window.look { viewer -> viewer.notices.all.filter { it.isError }.map { it.text } }.shouldBeEmpty()
            }
            window.click("Folder Folder 0")
            window.awaitText("Topic Folder 0/Topic 3")
            window.point("Topic Folder 0/Topic 3", 0.5, 0.5)
            window.wheel(400)
            window.picture("many-topics-scrolled")
        }
    }

    test("damaged settings, a damaged cache and a place on no screen are ignored").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = tempdir().toPath()
        val file = folder.put("match.bag", bag())
        val home = tempdir().toPath()
        RealWindow(home, file).use { it.awaitState("the log") { viewer -> viewer.library.state.entries.size == 1 } }
        val kept = Files.walk(home).use { files -> files.filter { Files.isRegularFile(it) }.toList() }
        for (damaged in kept) Files.write(damaged, ByteArray(300) { (it * 37).toByte() })
        RealWindow(home, file).use { it.awaitState("the log") { viewer -> viewer.current.recording != null && viewer.library.state.entries.size == 1 } }
        Files.writeString(
            home.resolve("settings.json"),
            """{"graphHeight": -40, "fitsGraphs": false, "recentFolders": ["\u0000", ""], "theme": "PINK",
               "window": {"x": 90000, "y": -90000, "width": -5, "height": 99999999, "isMaximized": false}}""",
        )
        RealWindow(home, file).use { window ->
            window.awaitState("the log") { it.current.recording != null }
            window.awaitGraphs()
        }
    }

    test("a folder without read permission is reported").config(enabledOrReasonIf = { needsOrdinaryUser() }) {
        val folder = tempdir().toPath()
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("---------"))
        try {
            RealWindow(tempdir().toPath(), folder).use { window ->
                window.awaitState("a sentence") { it.library.state.trouble != null }
                window.picture("closed-folder")
            }
        } finally {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"))
        }
    }
})

/** Waits until the window reads its file. A machine that stands still just then may only see that it was read. */
private fun RealWindow.awaitReading() = awaitState("the large file to be read") { it.tasks.all.isNotEmpty() || it.current.recording != null }

/** Returns a bag of 300,000 rows. */
private fun largeBag(folder: Path, name: String): Path {
    val topics = List(12) { if (it == 0) "Time|xaxis" else "Topic $it" }
    val file = folder.put(name, bagOf(topics, emptyList()))
    Files.newBufferedWriter(file, StandardOpenOption.APPEND).use { out ->
        for (row in 0 until 300_000) {
            out.append((row * 0.02).toString())
            for (topic in 1 until topics.size) out.append(',').append((row * topic % 1013).toString())
            out.append('\n')
        }
    }
    return file
}

/** Returns a bag of [count] topics in folders of a hundred. */
private fun manyTopics(count: Int): String = bagOf(
    topics = listOf("Time|xaxis") + (0 until count).map { "Folder ${it / 100}/Topic ${it % 100}" },
    rows = (0 until 20).map { row -> (0..count).joinToString(",") { "${row + it % 5}" } },
)

private fun needsOrdinaryUser(): Enabled = when {
    System.getProperty("user.name") == "root" -> Enabled.disabled("Nothing is closed to an administrator: run as another user.")
    "posix" !in FileSystems.getDefault().supportedFileAttributeViews() -> Enabled.disabled("This system has other permissions.")
    else -> needsDisplay
}
