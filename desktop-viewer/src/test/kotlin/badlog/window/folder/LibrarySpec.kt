package badlog.window.folder

import badlog.catalog.folder.FolderStore
import badlog.catalog.folder.IndexQueue
import badlog.catalog.folder.bag
import badlog.catalog.folder.matchValues
import badlog.catalog.folder.put
import badlog.catalog.folder.putSamples
import badlog.catalog.folder.samples
import badlog.core.recording.Severity
import badlog.exporter.BADLOG_VERSION
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.viewer.catalog.Content
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.layout.FolderLayouts
import badlog.window.layout.Layout
import badlog.window.layout.LayoutComparison
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.nio.file.attribute.PosixFilePermissions
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.seconds

/** Symbolic links, which only administrators create on Windows. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

/** Permissions of owner, group and others. */
private val IF_POSIX =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has other permissions")

@Tags("InCheck")
class LibrarySpec : FunSpec({
    val longest = 60.seconds

    fun newViewer(home: Path = tempdir().toPath()) = Viewer(MainScope(), UserFolders(home, home))

    /** Opens [folder] in [viewer], runs [steps], and closes the folder. */
    suspend fun watching(folder: Path, viewer: Viewer = newViewer(), steps: suspend (Viewer) -> Unit) {
        try {
            withContext(Dispatchers.Main) {
                viewer.scope.launch { viewer.newest.run() }
                viewer.library.open(folder)
            }
            steps(viewer)
        } finally {
            withContext(Dispatchers.Main) { viewer.library.close() }
        }
    }

    fun names(viewer: Viewer) = viewer.library.state.entries.map { it.fileName }

    test("new, growing, renamed and deleted files are followed in the list") {
        val folder = tempdir().toPath()
        val first = folder.put("first.bag", bag(100))
        watching(folder) { viewer ->
            eventually(longest) { names(viewer) shouldContainExactly listOf("first.bag") }
            folder.put("new folder/second.bag", bag(200))
            eventually(longest) { names(viewer) shouldContainExactlyInAnyOrder listOf("first.bag", "second.bag") }
            Files.writeString(first, "9999,5.5,1\n".repeat(50), StandardOpenOption.APPEND)
            eventually(longest) { viewer.library.state.entries.single { it.fileName == "first.bag" }.summary.samples shouldBe 450 }
            viewer.library.state.entries.single { it.fileName == "first.bag" }.summary.batteryMinimum shouldBe 5.5
            Files.move(first, folder.resolve("third.bag"))
            eventually(longest) { names(viewer) shouldContainExactlyInAnyOrder listOf("third.bag", "second.bag") }
            Files.delete(folder.resolve("third.bag"))
            eventually(longest) { names(viewer) shouldContainExactly listOf("second.bag") }
        }
    }

    test("the newest log is shown automatically") {
        val folder = tempdir().toPath()
        for (number in 1..5) folder.put("$number.bag", bag(values = matchValues(number)))
        watching(folder) { viewer ->
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("5.bag") }
            viewer.library.state.selected shouldBe folder.resolve("5.bag")
        }
    }

    test("a newer log replaces the one that was shown automatically, unless a person is using that") {
        val folder = tempdir().toPath()
        folder.put("1.bag", bag(values = matchValues(1)))
        watching(folder) { viewer ->
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("1.bag") }
            folder.put("2.bag", bag(values = matchValues(2)))
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("2.bag") }
            withContext(Dispatchers.Main) { viewer.view.send(PlaceAction.Show(1.0, 2.0)) }
            folder.put("3.bag", bag(values = matchValues(3)))
            eventually(longest) { viewer.library.state.newest?.fileName shouldBe "3.bag" }
            withContext(Dispatchers.Main) { viewer.newest.update(IndexQueue(), isComplete = true) }
            viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("2.bag")
        }
    }

    test("logs checked by a layout do not prevent the newest log, or a newer one, from being shown") {
        val folder = tempdir().toPath()
        val home = tempdir().toPath()
        for (number in 1..2) folder.put("$number.bag", bag(values = matchValues(number)))
        FolderLayouts(home.resolve("layouts")).update(folder) { Layout(Layout.VERSION, compared = LayoutComparison(listOf("1.bag"))) }
        val viewer = newViewer(home)
        watching(folder, viewer) {
            withContext(Dispatchers.Main) { viewer.scope.launch { viewer.layouts.autosave() } }
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("2.bag") }
            eventually(longest) { viewer.compared.state.loaded.keys shouldBe setOf(folder.resolve("1.bag")) }
            folder.put("3.bag", bag(values = matchValues(3)))
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe folder.resolve("3.bag") }
        }
        viewer.scope.cancel()
    }

    test("of a folder with a match.json, the match is opened, not the newest log") {
        val folder = tempdir().toPath()
        folder.put("1.bag", bag(100))
        val manifest = folder.put("match.json", """{"version":1,"files":[{"name":"1.bag"}]}""")
        val viewer = newViewer()
        watching(tempdir().toPath(), viewer) {
            withContext(Dispatchers.Main) { viewer.opener.openNamed(listOf(folder)) }
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe manifest }
            eventually(longest) { names(viewer).size shouldBe 1 }
        }
        viewer.scope.cancel()
    }

    test("a file that cannot be opened leaves the open log, which is still followed") {
        val folder = tempdir().toPath()
        val file = folder.put("1.bag", bag(100))
        val viewer = newViewer()
        watching(folder, viewer) {
            eventually(longest) { viewer.current.recording.shouldNotBeNull().file shouldBe file }
            withContext(Dispatchers.Main) { viewer.opener.openNamed(listOf(folder.put("picture.png", "\u0089PNG\r\n\u001a\n\u0000\u0000"))) }
            eventually(longest) { viewer.notices.all.single().isError shouldBe true }
            Files.writeString(file, "9999,5.5,1\n".repeat(50), StandardOpenOption.APPEND)
            eventually(longest) { viewer.current.recording.shouldNotBeNull().view.recording.rowCount shouldBe 150 }
            viewer.current.recording.shouldNotBeNull().file shouldBe file
        }
        viewer.scope.cancel()
    }

    test("known logs are listed the second time without reading a file") {
        val folder = tempdir().toPath()
        val home = tempdir().toPath()
        val file = folder.put("a.bag", bag(100))
        watching(folder, newViewer(home)) { viewer -> eventually(longest) { names(viewer).size shouldBe 1 } }
        eventually(longest) { FolderStore(folder, home.resolve("answers"), BADLOG_VERSION)[LogFile.of(file)].shouldNotBeNull() }
        // Only a reader notices other content of the same size at the same time.
        val written = Files.getLastModifiedTime(file)
        Files.writeString(file, Files.readString(file).replace("System/Battery Voltage", "System/Cattery Voltage"))
        Files.setLastModifiedTime(file, written)
        watching(folder, newViewer(home)) { viewer ->
            eventually(longest) { viewer.library.state.entries.single().summary.topics.map { it.name } shouldContain "System/Battery Voltage" }
        }
    }

    test("the rules run over each log in the background, and their results are stored for the next time") {
        val folder = tempdir().toPath()
        val home = tempdir().toPath()
        folder.putSamples(areSettled = true)
        fun found(viewer: Viewer) = viewer.library.state.entries.associate { it.fileName to it.found?.worst }
        watching(folder, newViewer(home)) { viewer ->
            eventually(longest) { found(viewer)["qualification-42.bag"] shouldBe Severity.ERROR }
        }
        fun kept() = FolderStore(folder, home.resolve("answers"), BADLOG_VERSION)[LogFile.of(folder.resolve("qualification-42.bag"))]?.found?.worst
        eventually(longest) { kept() shouldBe Severity.ERROR }
    }

    test("a folder of broken files is listed with a sentence for each, and readable parts are shown").config(enabledOrReasonIf = { IF_LINKS }) {
        val folder = tempdir().toPath()
        Files.write(folder.resolve("random.bag"), ByteArray(5000) { (it * 31 + it / 7).toByte() })
        val gz = Files.readAllBytes(samples.resolve("qualification-57.bag.gz"))
        Files.write(folder.resolve("half.bag.gz"), gz.copyOf(gz.size / 2))
        Files.write(folder.resolve("none.bag.gz"), gz.copyOf(5))
        folder.put("empty.bag", "")
        folder.put("cut.bag", bag().dropLast(20))
        folder.put("folder.bag/inside.bag", bag())
        Files.createSymbolicLink(folder.resolve("folder.bag/loop"), folder)
        Files.createSymbolicLink(folder.resolve("dangling.bag"), folder.resolve("nowhere"))
        folder.put(".hidden.bag", bag())
        folder.put("build.gradle", "")
        folder.put("build/built.bag", bag())
        if (Path.of("/usr/bin/mkfifo").let(Files::exists)) {
            ProcessBuilder("mkfifo", folder.resolve("pipe.bag").toString()).start().waitFor(60, TimeUnit.SECONDS) shouldBe true
        }
        watching(folder) { viewer ->
            eventually(longest) {
                names(viewer) shouldContainExactlyInAnyOrder
                    listOf("random.bag", "half.bag.gz", "none.bag.gz", "empty.bag", "cut.bag", "inside.bag")
            }
            val entries = viewer.library.state.entries.associateBy { it.fileName }
            entries.getValue("random.bag").summary.trouble.shouldNotBeNull()
            entries.getValue("half.bag.gz").summary.content shouldBe Content.SOMETHING
            entries.getValue("empty.bag").isGray shouldBe true
            entries.getValue("cut.bag").summary.content shouldBe Content.SOMETHING
            entries.getValue("inside.bag").summary.content shouldBe Content.SOMETHING
            withContext(Dispatchers.Main) { viewer.loader.open(folder.resolve("half.bag.gz")) }
            eventually(longest) { viewer.current.recording?.file shouldBe folder.resolve("half.bag.gz") }
            for (name in listOf("random.bag", "folder.bag", "nowhere.bag")) {
                withContext(Dispatchers.Main) { viewer.loader.open(folder.resolve(name)) }
                eventually(longest) { viewer.notices.all.toList().any { it.isError && name in it.text } shouldBe true }
            }
            viewer.current.recording?.file shouldBe folder.resolve("half.bag.gz")
        }
    }

    test("a missing folder is reported, and listed as soon as it exists") {
        val folder = tempdir().toPath().resolve("not yet")
        watching(folder) { viewer ->
            eventually(longest) { viewer.library.state.trouble.shouldNotBeNull() }
            folder.put("a.bag", bag())
            eventually(longest) { names(viewer) shouldContainExactly listOf("a.bag") }
            viewer.library.state.trouble shouldBe null
        }
    }

    test("a folder without read permission is reported, and the others are listed").config(enabledOrReasonIf = { IF_POSIX }) {
        val folder = tempdir().toPath()
        val closed = folder.put("closed/a.bag", bag()).parent
        folder.put("b.bag", bag())
        Files.setPosixFilePermissions(closed, PosixFilePermissions.fromString("---------"))
        try {
            // An administrator can read every folder.
            if (!Files.isReadable(closed)) {
                watching(folder) { viewer ->
                    eventually(longest) { names(viewer) shouldContainExactly listOf("b.bag") }
                    viewer.library.state.trouble.shouldNotBeNull()
                }
            }
        } finally {
            Files.setPosixFilePermissions(closed, PosixFilePermissions.fromString("rwx------"))
        }
    }
})
