package badlog.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.shouldBe
import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

private fun Path.put(name: String) {
    val file = resolve(name)
    Files.createDirectories(file.parent)
    Files.writeString(file, "x")
}

/** Symbolic links: on Windows only administrators make them. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

class FolderScanSpec : FunSpec({
    fun found(folder: Path) = FolderScan.of(folder).files.map { folder.relativize(it.path).joinToString("/") }.sortedBy { it.lowercase() }

    test("finds logs in all folders by their names, and skips hidden ones") {
        inFolder { folder ->
            listOf("b/Q10.bag", "b/Q9.bag", "a.csv", "c.wpilog.gz", "c.BADBAG", "d.tar.gz", ".hidden.bag", ".git/x.bag", "notes.txt")
                .forEach { folder.put(it) }
            found(folder) shouldBe
                listOf("a.csv", "b/Q10.bag", "b/Q9.bag", "c.BADBAG", "c.wpilog.gz")
        }
    }

    test("slices of a pack of rules are logs of the pack, not of the folder around it") {
        inFolder { folder ->
            listOf("a.bag", "our.badlog-rules/fires/Jammed/b.bag").forEach { folder.put(it) }
            found(folder) shouldBe listOf("a.bag")
            found(folder.resolve("our.badlog-rules")) shouldBe listOf("fires/Jammed/b.bag")
        }
    }

    test("a .dslog with its .dsevents is one log with the size of both, and each alone is one, too") {
        inFolder { folder ->
            listOf("a/one.dslog", "a/one.dsevents", "a/two.dslog", "three.dsevents", "three.DSLOG", "Four.DSLOG", "Four.DSEVENTS", "five.dslog.gz", "five.dsevents.gz")
                .forEach { folder.put(it) }
            found(folder) shouldBe listOf("a/one.dslog", "a/two.dslog", "five.dslog.gz", "Four.DSLOG", "three.dsevents", "three.DSLOG")
            val one = FolderScan.of(folder).files.single { it.name == "one.dslog" }
            one.size shouldBe 2
            one shouldBe LogFile.of(folder.resolve("a/one.dslog"))
        }
    }

    test("follows links, but not in circles").config(enabledOrReasonIf = { IF_LINKS }) {
        inFolder { folder ->
            folder.put("a/Q1.bag")
            Files.createSymbolicLink(folder.resolve("a/again"), folder)
            found(folder).size shouldBe 1
        }
    }

    test("shows when a file was last written, and its size") {
        inFolder { folder ->
            folder.put("Q1.bag")
            FolderScan.of(folder).files.single() shouldBe LogFile.of(folder.resolve("Q1.bag"))
            LogFile.of(folder.resolve("Q1.bag")).size shouldBe 1
        }
    }

    test("skips Gradle's build folders, but not other folders with that name") {
        inFolder { folder ->
            listOf("a/build.gradle", "a/build/Q1.bag", "b/build/Q2.bag").forEach { folder.put(it) }
            found(folder) shouldBe listOf("b/build/Q2.bag")
        }
    }

    test("a missing folder is reported") {
        inFolder { folder -> shouldThrow<IOException> { FolderScan.of(folder.resolve("none")) } }
    }
})
