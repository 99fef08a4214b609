"""Results as Vega-Lite specifications: plain data, the same for the page and for print."""
