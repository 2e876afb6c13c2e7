package badlog.viewer.draw.path

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldStartWith
import java.awt.image.BufferedImage
import java.io.File
import javax.imageio.ImageIO

class FieldFileSpec : FunSpec({
    fun folder(picture: (File) -> Unit): File = tempdir().also { folder ->
        File(folder, "field.json").writeText(
            """{"field-image":"f.png","field-corners":{"top-left":[0,0],"bottom-right":[40,20]},"field-size":[16,8],"field-unit":"meter"}""",
        )
        picture(File(folder, "f.png"))
    }

    fun File.field() = FieldFile.of(File(this, "a.bag").toPath())

    test("the field beside a log is read with its picture, which is embedded in pages") {
        val folder = folder { ImageIO.write(BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB), "png", it) }
        val found = folder.field()
        found.problem.shouldBeNull()
        found.field.length shouldBe 16.0
        found.picture shouldBe File(folder, "f.png").readBytes()
        fieldOfJson(found.json!!).image!!.source shouldStartWith "data:image/png;base64,iVBOR"
        found.field.image!!.source shouldBe fieldOfJson(found.json).image!!.source
        FieldFile.read(File(folder, "field.json").toPath()).json shouldBe found.json
        FieldFile.of(File(File(folder, "deep"), "a.bag").toPath(), top = folder.toPath()).json shouldBe found.json
    }

    test("without a file the field is plain, and an unusable file is reported in a sentence") {
        tempdir().field().run { json to problem } shouldBe (null to null)
        folder { }.field().problem!! shouldEndWith "is not used: Its picture “f.png” cannot be read; put it beside the file."
        folder { it.writeText("GIF89a") }.field().problem!! shouldEndWith "Its picture “f.png” is neither PNG nor JPEG; save it as one of them."
        folder { it.writeBytes(ByteArray(4_000_000)) }.field().problem!! shouldEndWith "Its picture “f.png” is larger than 3 MB; save it smaller."
        val damaged = tempdir().also { File(it, "field.json").writeText("{") }
        damaged.field().problem!! shouldEndWith "It is not a JSON object; select the field’s .json file."
        FieldFile.read(File(damaged, "none.json").toPath()).problem!! shouldEndWith "It cannot be read; check its name and its permissions."
    }
})
