package badlog.page

import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.util.Base64
import javax.imageio.ImageIO

/** The paths of robots. */
@Tags("InCheck")
internal class PathSpec : PageSpec({
    val page by lazy { TestPages.ofSample("wrong-turn.bag") }

    browserTest("a path is drawn with the robot at the cursor, zoomed and pinned") {
        onPage(page) {
            step("a log with poses begins with its path, driven and planned, and the robot at the cursor") {
                for (screen in listOf(Screen.PHONE, Screen.WIDE)) {
                    show(screen)
                    texts("#board .graph-title") shouldContainExactly listOf("Path")
                    texts("#board .legend-name") shouldContainExactly listOf("Drive/Pose", "Target Pose", "Vision/Pose")
                    for (line in 0..2) pathPixels(line) shouldBeGreaterThan 60
                    pathPixels(0, layer = 1) shouldBe 0
                    hoverPath(0.47, 0.45)
                    pathValues()[0] shouldContain "m · "
                    pathPixels(0, layer = 1) shouldBeGreaterThan 60
                    keepScreenshot("path-${screen.width}")
                    act { mouseTo(3, 3) }
                    press(Keys.ESCAPE, Keys.ESCAPE)
                }
            }
            step("Escape cancels a drag over a path, a click pins the cursor, the wheel with Ctrl zooms, a double click shows everything") {
                val (x, y, width, height) = pathBox()
                fun picture() = script("return document.querySelector('.xy').toDataURL()")
                fun pictures() = script("return [...document.querySelectorAll('.xy')].map(canvas => canvas.toDataURL())")
                val untouched = pictures()
                // A drag draws a frame; with Shift, it moves the plane.
                for (key in listOf("", Keys.SHIFT)) {
                    act {
                        if (key.isNotEmpty()) keyDown(key)
                        mouseTo((x + width * 0.3).toInt(), (y + height * 0.3).toInt()).mouseDown()
                        mouseTo((x + width * 0.6).toInt(), (y + height * 0.6).toInt())
                        sendKeys(Keys.ESCAPE).mouseTo((x + width * 0.99).toInt(), (y + height * 0.99).toInt()).mouseUp()
                        if (key.isNotEmpty()) keyUp(key)
                        this
                    }
                    act { mouseTo(3, 3) }
                    pictures() shouldBe untouched
                }
                hoverPath(0.47, 0.45)
                act { mouseTo((x + width * 0.47).toInt(), (y + height * 0.45).toInt()).mouseDown().mouseUp() }
                elements(".cursor-line.is-pinned").size shouldBeGreaterThan 0
                val before = picture()
                script(
                    "const at = {clientX: arguments[0], clientY: arguments[1]};" +
                        "document.querySelectorAll('.xy')[1].dispatchEvent(new WheelEvent('wheel', {deltaY: -60, ctrlKey: true, ...at}))",
                    x + width / 2,
                    y + height / 2,
                )
                settle()
                picture() shouldNotBe before
                doubleClick((x + width * 0.5).toInt(), (y + height * 0.5).toInt())
                picture() shouldBe before
            }
        }
    }

    browserTest("the picture of the field is behind the path, in the size given by its corners") {
        val picture = ByteArrayOutputStream().also { out ->
            // Nothing else on the page has this green.
            val image = BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB)
            for (x in 0 until 200) for (y in 0 until 100) image.setRGB(x, y, 0x00FF00)
            ImageIO.write(image, "png", out)
        }.toByteArray()
        val source = "data:image/png;base64," + Base64.getEncoder().encodeToString(picture)
        val field = "{\"field-image\":\"$source\",\"field-corners\":{\"top-left\":[0,0],\"bottom-right\":[200,100]},\"field-size\":[16.5,8],\"field-unit\":\"meter\"}"
        onPage(TestPages.ofSample("wrong-turn.bag", PageAdditions(field = field))) {
            fun greenShare() = number(
                """
                const canvas = document.querySelector('.xy')
                const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data
                let green = 0
                for (let i = 0; i < data.length; i += 4) if (data[i + 1] > 200 && data[i] < 60 && data[i + 2] < 60) green++
                return green / canvas.width / canvas.height
                """.trimIndent(),
            )
            await("the picture") { greenShare() > 0.4 }
            keepScreenshot("path-picture")
        }
    }
})
