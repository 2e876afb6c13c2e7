package badlog.report

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.IOException
import java.nio.file.Files

class FolderScanSpec : FunSpec({
    test("finds logs in all folders, in the order of their names with numbers by size") {
        inFolder { folder ->
            listOf("b/Q10.bag", "b/Q9.bag", "a.csv", "c.wpilog.gz", "c.BADBAG", "d.tar.gz", ".hidden.bag", ".git/x.bag", "notes.txt")
                .forEach { folder.put(it, "x") }
            logsIn(folder).map { folder.relativize(it.path).joinToString("/") } shouldBe
                listOf("a.csv", "b/Q9.bag", "b/Q10.bag", "c.BADBAG", "c.wpilog.gz")
        }
    }

    test("follows no link round in circles") {
        inFolder { folder ->
            folder.put("a/Q1.bag", "x")
            try {
                Files.createSymbolicLink(folder.resolve("a/again"), folder)
            } catch (_: UnsupportedOperationException) {
                return@inFolder
            }
            logsIn(folder).size shouldBe 1
        }
    }

    test("a folder that is not there is told") {
        inFolder { folder -> shouldThrow<IOException> { FolderScan.of(folder.resolve("none")) } }
    }
})
