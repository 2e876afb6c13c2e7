package badlog.page

/**
 * Returns the number of pixels with the color of line [index] in the first graph of y over x. The pixels are below the cursors, or in their
 * [layer] 1.
 */
internal fun OpenPage.pathPixels(index: Int, layer: Int = 0): Int {
    val color = color("--line-$index")
    return number(
        """
        const canvas = document.querySelectorAll('.xy')[arguments[0]]
        const copy = document.createElement('canvas')
        copy.width = canvas.width
        copy.height = canvas.height
        const context = copy.getContext('2d', {willReadFrequently: true})
        context.drawImage(canvas, 0, 0)
        const data = context.getImageData(0, 0, copy.width, copy.height).data
        let count = 0
        for (let i = 0; i < data.length; i += 4) {
            if (data[i + 3] > 120 && Math.abs(data[i] - arguments[1]) + Math.abs(data[i + 1] - arguments[2]) + Math.abs(data[i + 2] - arguments[3]) < 60) count++
        }
        return count
        """.trimIndent(),
        layer,
        color shr 16 and 255,
        color shr 8 and 255,
        color and 255,
    ).toInt()
}

/** Returns the values at the cursor in the legends of the board. */
internal fun OpenPage.pathValues(): List<String> = texts("#board .legend-entry .value")

/** Returns the position of the first graph of y over x on the screen: left, top, width and height. */
internal fun OpenPage.pathBox(): List<Double> {
    val numbers = script("const b = document.querySelector('.xy').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]") as List<*>
    return numbers.map { (it as Number).toDouble() }
}

/** Moves the mouse to these shares of the graph's width and height. */
internal fun OpenPage.hoverPath(across: Double, down: Double) {
    val (x, y, width, height) = pathBox()
    act { mouseTo((x + width * across).toInt(), (y + height * down).toInt() + 3).mouseTo((x + width * across).toInt(), (y + height * down).toInt()) }
}
