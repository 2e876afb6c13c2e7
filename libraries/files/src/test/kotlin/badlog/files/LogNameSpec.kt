package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LogNameSpec : FunSpec({
    test("a name is a stem, the ending of a log in any case, and perhaps .gz") {
        for ((name, parts) in mapOf(
            "match.bag" to Triple("match", ".bag", false),
            "match.BAG.gz" to Triple("match", ".BAG", true),
            "q.42.wpilog" to Triple("q.42", ".wpilog", false),
            "disk.img.gz" to Triple("disk.img", "", true),
            "notes.txt" to Triple("notes.txt", "", false),
            ".bag" to Triple(".bag", "", false),
            ".gz" to Triple(".gz", "", false),
        )) {
            LogName.of(name).run { Triple(stem, ending, isGzip) } shouldBe parts
        }
    }

    test("tables and compressed files may be logs; bags and WPILOGs always are") {
        listOf("a.bag", "a.badbag.gz", "a.csv", "a.gz", "a.txt").map { LogName.of(it).mayBeLog } shouldBe
            listOf(true, true, true, true, false)
        listOf("a.bag", "a.badbag.gz", "a.csv", "a.gz", "a.wpilog").map { LogName.of(it).isOnlyOfLogs } shouldBe
            listOf(true, true, false, false, true)
    }
})
