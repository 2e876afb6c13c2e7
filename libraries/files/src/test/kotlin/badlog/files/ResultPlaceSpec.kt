package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.writeText

class ResultPlaceSpec : FunSpec({
    test("a name with an ending is a file; without one, or with a slash, it is a folder") {
        for (file in listOf("a.bag", "page.html", "out/match.bag.gz", "../q42.2026")) ResultPlace.of(file).isFolder shouldBe false
        for (folder in listOf("out", "out/", "match.bag/", ".", "..", ".hidden", "deep/er", "odd.")) ResultPlace.of(folder).isFolder shouldBe true
    }

    test("a folder that exists is one under any name, and so is a file, except with a slash behind it") {
        inFolder { folder ->
            ResultPlace.of("${(folder / "pages.2026").createDirectory()}").isFolder shouldBe true
            (folder / "page.html").writeText("")
            ResultPlace.of("${folder / "page.html"}").isFolder shouldBe false
            (folder / "page").writeText("")
            ResultPlace.of("${folder / "page"}").isFolder shouldBe false
            ResultPlace.of("${folder / "page"}/").isFolder shouldBe true
        }
    }
})
