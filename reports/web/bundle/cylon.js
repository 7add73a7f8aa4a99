"use strict";(()=>{function o(r){}function e(r){}var p={report:o,view:e},t=document.getElementById("app"),n=p[document.documentElement.dataset.page??""];t&&n&&n(t);})();
