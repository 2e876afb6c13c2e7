package badlog.window.app

import badlog.window.settings.Settings
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

class StartPlaceSpec : FunSpec({
    val folder = tempdir().toPath()
    val file = Files.createFile(folder.resolve("match.bag"))

    test("a folder or file that the argument names is opened") {
        StartPlace.of("$folder", Settings(), null) shouldBe StartPlace(folder, null, null)
        StartPlace.of("$file", Settings(), null) shouldBe StartPlace(folder, file, null)
        val match = tempdir().toPath()
        val manifest = Files.writeString(match.resolve("match.json"), """{"version":1,"files":[{"name":"match.bag"}]}""")
        StartPlace.of("$match", Settings(), null) shouldBe StartPlace(match, manifest, null)
    }

    test("the pit view can be requested before or after the folder") {
        for (arguments in listOf(arrayOf("$folder", "--pit"), arrayOf("--pit", "$folder"))) {
            StartPlace.of(arguments, Settings(), null) shouldBe StartPlace(folder, null, null, isPit = true)
        }
        StartPlace.of(arrayOf("$folder"), Settings(), null).isPit shouldBe false
    }

    test("without an argument, the last folder that still exists is opened") {
        val remembered = Settings(recentFolders = listOf("$folder/gone", "\u0000", "$folder"))
        StartPlace.of(null, remembered, null) shouldBe StartPlace(folder, null, null)
        StartPlace.of(null, Settings(), folder) shouldBe StartPlace(folder, null, null)
    }

    test("a name that does not exist, or cannot be a name, is reported") {
        for (name in listOf("$folder/matsch.bag", "match\u0000.bag")) {
            val place = StartPlace.of(name, Settings(recentFolders = listOf("$folder")), null)
            place.folder shouldBe folder
            place.complaint.shouldNotBeNull() shouldContain name
        }
    }
})
