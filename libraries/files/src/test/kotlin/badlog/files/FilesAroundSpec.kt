package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import java.nio.file.Files
import java.nio.file.Path

class FilesAroundSpec : FunSpec({
    fun Path.with(name: String): Path = resolve(name).also {
        Files.createDirectories(it.parent)
        Files.createFile(it)
    }

    test("files around a log are in its folder, the folders in that, and the folders beside it") {
        inFolder { folder ->
            val near = listOf("day/logs/a.hoot", "day/logs/can/b.hoot", "day/hoot/c.hoot", "day/hoot/Q42/d.hoot").map { folder.with(it) }
            val others = listOf("day/e.hoot", "day/logs/can/more/f.hoot", "day/hoot/Q42/more/g.hoot", "h.hoot", "other/i.hoot", "day/logs/can/j.txt")
            val hidden = listOf("day/logs/.k.hoot", "day/.trash/l.hoot", "day/hoot/.trash/m.hoot", "day/hoot/node_modules/n.hoot")
            (others + hidden).forEach { folder.with(it) }
            val log = folder.with("day/logs/log.hoot")
            filesAround(log) { it.endsWith(".hoot") }.toSet() shouldBe near.map { it.toAbsolutePath().normalize() }.toSet()
        }
    }

    test("the user's home folder is not looked through") {
        inFolder { folder ->
            val home = (folder.toAbsolutePath().normalize()).resolve("users/ada")
            val near = home.with("Downloads/day/b.hoot")
            home.with("Documents/c.hoot")
            val beside = home.with("a.hoot")
            folder.with("users/bob/d.hoot")
            fun around(log: String) = filesAround(home.resolve(log), home) { it.endsWith(".hoot") }
            around("Downloads/log.bag") shouldBe listOf(near)
            around("log.bag") shouldBe listOf(beside)
        }
    }

    test("of very many files, only the nearest are looked at") {
        inFolder { folder ->
            repeat(5200) { folder.with("day/other/$it.hoot") }
            repeat(40) { folder.with("day/logs/$it.hoot") }
            val found = filesAround(folder.with("day/logs/log.bag")) { it.endsWith(".hoot") }
            found shouldHaveSize 4998
            found.count { it.parent.fileName.toString() == "logs" } shouldBe 40
        }
    }

    test("a file without a folder has no files around it") {
        filesAround(Path.of("/").resolve("no such folder at all").resolve("log.bag")) { true }.shouldBeEmpty()
    }
})
