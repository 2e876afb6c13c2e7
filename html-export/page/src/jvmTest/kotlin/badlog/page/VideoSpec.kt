package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.viewer.session.video.VideoAlignment
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlin.math.abs
import kotlin.math.floor

/** A video beside the data: the robot is enabled at 7 s. */
@Tags("InCheck")
internal class VideoSpec : PageSpec({
    val bag by lazy {
        bagOf(listOf(TIME, BagTopic("Ramp", "m"), BagTopic("Enabled")), 1501) { row, column ->
            when (column) {
                0 -> row / 50.0
                1 -> row / 50.0
                else -> if (row >= 350) 1 else 0
            }
        }
    }
    val page by lazy { TestPages.of(bag, additions = PageAdditions(rules = RuleSet.BUILT_IN)) }

    fun OpenPage.awaitVideo() = await("the video") { number("return document.querySelector('#video video').readyState") >= 2 }

    fun OpenPage.pick() {
        script(CountedVideo.pick)
        awaitVideo()
        // A browser lets only a person start a video with sound.
        script("document.querySelector('#video video').muted = true")
        settle()
    }

    fun OpenPage.shown() = number("return ${CountedVideo.SHOWN}").toInt()

    /** Returns the position of the cursor, in seconds; NaN if it is not placed. */
    fun OpenPage.cursor() = texts(".cursor-readout").single().removeSuffix(" s").toDoubleOrNull() ?: Double.NaN

    /** Waits until the video shows frame [number], the browser has reported it, and the screen has followed. */
    fun OpenPage.awaitFrame(number: Int) {
        await("frame $number") {
            shown() == number && abs(number("return reports.last") * CountedVideo.FRAMES_PER_SECOND - number) < 0.5 && script("return video().seeking") == false
        }
        settle()
    }

    /** Goes to frame [number] with the video's own controls. */
    fun OpenPage.goToFrame(number: Int) {
        script("document.querySelector('#video video').currentTime = arguments[0]", (number + 0.5) / CountedVideo.FRAMES_PER_SECOND)
        awaitFrame(number)
    }

    fun OpenPage.openAligned() {
        pick()
        script("location.hash = '#v=5'")
        settle()
    }

    fun OpenPage.setSpeed(speed: String) {
        script("const s = document.querySelector('#video-speed'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))", speed)
    }

    /** Returns whether the cursor is within a frame of the picture, and the video is paused. */
    fun OpenPage.isAtCursor() = abs((cursor() - 5) * CountedVideo.FRAMES_PER_SECOND - shown()) <= 1 && script("return video().seeking") == false

    browserTest("video and cursor move each other, frame by frame and while it plays, and the alignment is remembered") {
        onPage(page, script = REPORTS) {
            step("one button marks the frame in which the robot is enabled; from then on, video and cursor move each other") {
                element("#video").isDisplayed shouldBe false
                pick()
                element("#video").isDisplayed shouldBe true
                texts("#video h2").single() shouldBe "match.webm"
                // The end of a long name distinguishes videos.
                script("document.querySelector('#video h2 bdi').textContent = 'match-'.repeat(40) + '42.webm'")
                number(
                    """const [all, name] = ['h2', 'h2 bdi'].map(it => document.querySelector('#video ' + it).getBoundingClientRect());
                    return name.right - all.right""",
                ) shouldBe (0.0 plusOrMinus 1.0)
                goToFrame(60)
                texts(".cursor-readout").single() shouldBe ""
                click("#video-enabled")
                cursor() shouldBe (7.0 plusOrMinus 0.02)
                for (frame in 0 until CountedVideo.FRAMES step 150) {
                    goToFrame(frame)
                    await("the cursor at frame $frame") { abs(cursor() - 5 - frame / 30.0) < 0.02 }
                }
                // 30 s across.
                for (across in listOf(0.9, 0.2, 0.201)) {
                    graph("Ramp").click(across)
                    val frame = floor((cursor() - 5) * 30).toInt().coerceIn(0, CountedVideo.FRAMES - 1)
                    await("the frame at ${cursor()} s") { abs(shown() - frame) <= 1 }
                }
                keepScreenshot("video")
            }
            step("frame and cursor differ by at most one frame at five times and a quarter of its speed") {
                for ((speed, halts) in listOf("5" to listOf(2.0, 5.0), "0.25" to listOf(0.2, 0.4))) {
                    goToFrame(0)
                    setSpeed(speed)
                    number("return document.querySelector('#video video').playbackRate") shouldBe speed.toDouble()
                    script("window.samples = []")
                    for (halt in halts) {
                        script("window.isOver = false; sample(); video().play()")
                        await("second $halt at $speed times") { number("return video().currentTime") >= halt }
                        script("video().pause(); window.isOver = true")
                        await("picture and cursor after $halt s at $speed times") { isAtCursor() }
                    }
                    val samples = (script("return window.samples") as List<*>).map { pair -> (pair as List<*>).map { it.toString().toDouble() } }
                    samples.shouldNotBeEmpty()
                    for ((frame, cursor) in samples) {
                        withClue("$speed times, frame at $frame s, cursor at $cursor s") {
                            (cursor - 5 - frame) * CountedVideo.FRAMES_PER_SECOND shouldBe (0.0 plusOrMinus 1.0)
                        }
                    }
                }
            }
            script("reports.areLost = false; video().pause()")
            setSpeed("1")
            step("the keys , and . and their buttons step by exactly one frame, and the cursor follows") {
                goToFrame(100)
                for ((key, frame) in listOf("." to 101, "." to 102, "," to 101)) {
                    press(key)
                    awaitFrame(frame)
                    await("the cursor") { abs(cursor() - 5 - frame / 30.0) < 0.02 }
                }
                click("#next-frame")
                awaitFrame(102)
                click("#previous-frame")
                awaitFrame(101)
            }
            step("a pause puts the cursor at the displayed frame, even if a busy browser has not reported that frame") {
                goToFrame(30)
                await("the cursor at frame 30") { isAtCursor() }
                script("reports.areLost = true; video().play()")
                await("half a second more") { number("return video().currentTime") >= 1.5 }
                cursor() shouldBe (6.0 plusOrMinus 0.02)
                script("video().pause()")
                await("picture, cursor and report") {
                    isAtCursor() && cursor() >= 6.4 && abs(number("return reports.last") * CountedVideo.FRAMES_PER_SECOND - shown()) < 0.5
                }
            }
            step("at its end the video and the cursor are at the last frame, and it plays again from its start") {
                goToFrame(CountedVideo.FRAMES - 15)
                // Most frames are skipped. The page thus cannot know the length of a frame, and the last one is not reported.
                setSpeed("5")
                script("reports.areLost = true; video().play()")
                await("the last picture and cursor") { shown() == CountedVideo.FRAMES - 1 && abs(cursor() - 5 - (CountedVideo.FRAMES - 1) / 30.0) < 0.002 }
                await("the end") { script("return video().ended") == true }
                script("video().play()")
                await("the first pictures") { number("return video().currentTime") < 5 }
            }
            script("reports.areLost = false; video().pause()")
            setSpeed("1")
            step("video and cursor are unlinked and aligned again at this frame, which is remembered and part of the link") {
                goToFrame(90)
                await("the cursor at 8 s") { abs(cursor() - 8) < 0.02 }
                click("#video-link")
                graph("Ramp").click(0.5)
                script("return video().seeking") shouldBe false
                shown() shouldBe 90
                click("#video-link")
                val at = cursor()
                goToFrame(120)
                await("the cursor a second later") { abs(cursor() - at - 1) < 0.02 }
                script("Object.defineProperty(navigator, 'clipboard', {value: {writeText: async text => { window.copied = text }}})")
                click("#copy-link")
                await("the link") { script("return window.copied") != null }
                (script("return window.copied") as String).substringAfter("&v=").toDouble() shouldBe (at - 3 plusOrMinus 0.02)
                script("location.hash = ''")
                reload()
                pick()
                element("#video-link").getAttribute("aria-pressed") shouldBe "true"
                goToFrame(90)
                await("the cursor where it was put") { abs(cursor() - at) < 0.02 }
            }
        }
    }

    browserTest("a video is aligned by the displayed frame, even if a busy browser has not reported it yet") {
        onPage(page, script = REPORTS) {
            pick()
            goToFrame(30)
            script("reports.areLost = 'for long'; video().currentTime = 35.5 / 30")
            await("frame 35") { shown() == 35 && script("return video().seeking") == false }
            click("#video-enabled")
            script("reports.areLost = false")
            goToFrame(65)
            await("the cursor a second after the robot was enabled") { abs(cursor() - 8) < 0.035 }
        }
    }

    browserTest("video and values at the cursor share the right side, and nothing covers the graphs or the bar’s texts") {
        onPage(TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)), Screen(1366, 768)) {
            script("location.hash = '#v=85&t=93.7&x=85:105'")
            pick()
            settle()
            keepScreenshot("video-light")
            press("v")
            for (isDark in listOf(false, true)) {
                step("dark: $isDark") {
                    show(Screen(1366, 768, isDark = isDark))
                    val box = "const b = s => document.querySelector(s).getBoundingClientRect(); return "
                    (number(box + "b('#cursor-values').top - b('#video').bottom") >= 0) shouldBe true
                    (number(box + "b('#video').left - b('.graph').right") >= 0) shouldBe true
                    (number(box + "b('.place').top - b('.zoom-buttons').bottom") >= 0) shouldBe true
                    element(".cursor-readout").text shouldBe "93.700 s"
                    if (isDark) keepScreenshot("video-values")
                    if (isDark) seriousForReaders() shouldBe emptyList()
                }
            }
        }
    }

    browserTest("a phone shows the video below or beside the graphs, and an unplayable one, or one without time, is reported") {
        step("a phone shows the video below or beside the graphs; an unplayable one is reported") {
            onPage(page) {
                step("a video that the browser cannot play is reported, also a dropped one, and a layout is still opened") {
                    script(DROP)
                    await("the sentence") { texts("#video [role=status]").single().isNotEmpty() && "cannot" in texts("#video [role=status]").single() }
                    texts("#video [role=status]").single() shouldStartWith "This browser cannot play phone.mov."
                    // A playable video takes its place.
                    pick()
                    texts("#video [role=status]").single() shouldContain "Find the first frame"
                }
                step("on a phone the video is a sheet over the foot of the page, and leaves room for the graphs") {
                    show(Screen.PHONE)
                    openAligned()
                    val box = "const b = document.querySelector('#video').getBoundingClientRect(); return "
                    number(box + "b.bottom") shouldBe 844.0
                    (number(box + "b.top") > 400) shouldBe true
                    number("return document.documentElement.scrollWidth") shouldBe 390.0
                    keepScreenshot("phone-video")
                }
                step("on a phone held sideways, the video and the values at the cursor are beside the graphs") {
                    show(Screen(844, 390, density = 2.0, isPhone = true, isDark = true))
                    press("v")
                    settle()
                    val box = "const b = s => document.querySelector(s).getBoundingClientRect(); return "
                    (number(box + "b('#video').left - b('.graph').right") >= 0) shouldBe true
                    (number(box + "b('#video').left - b('#cursor-values').right") >= 0) shouldBe true
                    (number(box + "390 - b('#video').bottom") >= 0) shouldBe true
                    number("return document.documentElement.scrollWidth") shouldBe 844.0
                    keepScreenshot("phone-sideways-video")
                }
            }
        }
        step("a page without time on x offers no video, and gives the reason when one is dropped") {
            onPage(TestPages.of("Distance (m),A\n0,1\n1,2\n", "two.csv")) {
                element("#video-button").isDisplayed shouldBe false
                script(DROP)
                await("the sentence") { VideoAlignment.NO_TIME in texts(".notice").joinToString() }
            }
        }
    }
})

/** Drops a file with the name of a video. */
private const val DROP = """(() => {
const data = new DataTransfer()
data.items.add(new File(['no pictures'], 'phone.mov', {type: 'video/quicktime'}))
document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}))
})()"""

/**
 * While `reports.areLost`, the browser reports no frames; if that is true, only until the next seek. After `sample()`, records for each
 * displayed frame its start and the page's cursor. The picture can be read only while the video is paused, because a canvas may already get
 * the next one.
 */
private const val REPORTS = """
window.video = () => document.querySelector('#video video')
window.reports = {areLost: false, last: -1}
const request = HTMLVideoElement.prototype.requestVideoFrameCallback
HTMLVideoElement.prototype.requestVideoFrameCallback = function (callback) {
    return request.call(this, (now, shown) => {
        const report = () => {
            callback(now, shown)
            reports.last = shown.mediaTime
        }
        if (reports.areLost) this.requestVideoFrameCallback(callback)
        else report()
    })
}
document.addEventListener('seeking', () => { if (reports.areLost === true) reports.areLost = false }, true)
window.sample = () => request.call(video(), (_, shown) => {
    // The page writes where the cursor is before the next picture; it has asked for that before. A frame of before a seek means nothing.
    const isOld = video().seeking
    requestAnimationFrame(() => { if (!isOld) samples.push([shown.mediaTime, parseFloat(document.querySelector('.cursor-readout').textContent)]) })
    if (!window.isOver) sample()
})
"""
